#!/usr/bin/python3
"""Spoils the scenes of corpus/ and judges what the program makes of them: fuzz.py [--inputs N] [--seed S] …

Input I of seed S is the same on every machine. What fails is kept in OUT/failures with the command that repeats it. A campaign that was cut off goes on: what is judged stands in OUT/judged.csv.
"""

import argparse
import collections
import csv
import hashlib
import random
import shutil
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

sys.dont_write_bytecode = True
HERE = Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parents[1] / "cases")]
import caselib  # noqa: E402
import fuzz_judge  # noqa: E402
import fuzz_mutations  # noqa: E402

CORPUS = HERE / "corpus"


def remove(folder):
    """Also while MPI, behind the end of the run, still takes away its own files in there."""
    while folder.exists():
        shutil.rmtree(folder, ignore_errors=True)


class Fuzzer:
    def __init__(self, program, seed, scratch, limit=30, ordinary=None):
        self.seed, self.scratch = seed, Path(scratch)
        self.scratch.mkdir(parents=True, exist_ok=True)
        self.judge = fuzz_judge.Judge(program, limit)
        self.ordinary = fuzz_judge.Judge(ordinary, 4 * limit) if ordinary else None
        self.corpus = self.scratch / "corpus"
        self.make_corpus()

    def make_corpus(self):
        """The scenes, with the restart files that `saved` writes for `resumed`, which names one, and `newest`, which asks for the newest."""
        shutil.rmtree(self.corpus, ignore_errors=True)
        shutil.copytree(CORPUS, self.corpus)
        shutil.copytree(self.corpus / "resumed", self.corpus / "newest")
        newest = self.corpus / "newest" / "in.script"
        newest.write_text(newest.read_text().replace("state.4", "state.*"))
        place = self.fresh("saved")
        shutil.copytree(self.corpus / "saved", place / "run")
        code, _, _, screen = self.judge.run(place, 1)
        if code != 0:
            sys.exit(f"fuzz: the scene 'saved' does not run:\n{screen[-2000:]}")
        for name in ("state.4", "state.8"):
            shutil.copy(place / "run" / name, self.corpus / "newest")
        shutil.copy(place / "run" / "state.4", self.corpus / "resumed")
        self.scenes = sorted(path for path in self.corpus.iterdir() if path.is_dir())
        self.vocabulary = fuzz_mutations.Vocabulary((scene / "in.script").read_bytes() for scene in self.scenes)

    def fresh(self, name):
        place = self.scratch / name
        remove(place)
        place.mkdir()
        return place

    def place(self, index):
        """A folder with input `index` in its sub-folder run, and the number of ranks that read it."""
        rng = random.Random(f"{self.seed} {index}")
        place = self.fresh(f"input{index}")
        fuzz_mutations.prepare(rng, self.scenes, place / "run", self.vocabulary)
        return place, rng.choice([1, 1, 2])

    def input(self, index):
        """The verdict on input `index`; its folder stays when it is a fault."""
        place, ranks = self.place(index)
        verdict = self.judge(place, ranks)
        if verdict.unsure and self.ordinary:
            place, ranks = self.place(index)
            verdict = self.ordinary(place, ranks)
        if verdict.good:
            remove(place)
        return verdict

    def again(self, index):
        return f"tests/robustness/fuzz.py --program {self.judge.program} --seed {self.seed} --only {index} --out {self.scratch}"

    def keep(self, index, verdict, failures):
        """The input as it was, what the program said, and how to repeat it."""
        folder = failures / f"seed{self.seed}_input{index}"
        shutil.rmtree(folder, ignore_errors=True)
        screen = (self.scratch / f"input{index}" / "screen").read_bytes()
        place, ranks = self.place(index)
        shutil.copytree(place / "run", folder)
        (folder / "screen").write_bytes(screen)
        (folder / "verdict").write_text(f"{verdict}\nranks: {ranks}\nagain: {self.again(index)}\n")
        remove(place)
        return folder


def fingerprint(program, seed):
    """Of all that decides a verdict."""
    digest = hashlib.sha256(Path(program).read_bytes() + str(seed).encode())
    for path in sorted(path for path in [*HERE.glob("fuzz*.py"), *CORPUS.rglob("*")] if path.is_file()):
        digest.update(path.read_bytes())
    return digest.hexdigest()


class Record:
    """What is judged already, by this program and these files."""

    def __init__(self, folder, mark):
        self.path = folder / "judged.csv"
        lines = list(csv.reader(self.path.open(newline=""))) if self.path.exists() else []
        self.verdicts = {}
        if lines and lines[0] == [mark]:
            self.verdicts = {int(line[0]): fuzz_judge.Verdict(line[1], line[2]) for line in lines[1:] if len(line) == 3}
        else:
            self.path.write_text(mark + "\n")

    def add(self, index, verdict):
        self.verdicts[index] = verdict
        with self.path.open("a", newline="") as file:
            csv.writer(file).writerow([index, verdict.word, verdict.detail])


def campaign(fuzzer, indices, jobs, record, failures, show):
    """Judges what the record does not hold yet; the faults."""
    def judge(index):
        verdict = fuzzer.input(index)
        kept = None if verdict.good else fuzzer.keep(index, verdict, failures)
        return index, verdict, kept

    left = [index for index in indices if index not in record.verdicts]
    with ThreadPoolExecutor(jobs) as pool:
        for done, (index, verdict, kept) in enumerate(pool.map(judge, left), 1):
            record.add(index, verdict)
            if kept:
                print(f"input {index}: {verdict}\n  kept in {kept}\n  again: {fuzzer.again(index)}", flush=True)
            elif show or done % 100 == 0:
                print(f"{done} of {len(left)}" + (f": input {index}: {verdict}" if show else ""), flush=True)
    return [index for index in indices if not record.verdicts[index].good]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", default=caselib.program(), help="the program; better one with sanitizers")
    parser.add_argument("--ordinary", help="one without, for what is too slow or too large with sanitizers: it has four times the time")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--inputs", type=int, default=100)
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("--only", type=int, nargs="+", help="these inputs, judged anew and each shown")
    parser.add_argument("--limit", type=float, default=30, help="seconds until a run is asked to end, and again until it counts as hung")
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--out", type=Path, help="folder for the record and the failures; default: a temporary one")
    parser.add_argument("--show", action="store_true", help="each verdict")
    given = parser.parse_args()
    if not given.program:
        sys.exit("fuzz: no program; name one with --program")
    out = (given.out or Path(tempfile.mkdtemp(prefix="swellflow_fuzz_"))).absolute()
    fuzzer = Fuzzer(given.program, given.seed, out / "scratch", given.limit, given.ordinary)
    record = Record(out, fingerprint(given.program, given.seed))
    for index in given.only or ():
        record.verdicts.pop(index, None)
    indices = given.only or range(given.first, given.first + given.inputs)
    failures = out / "failures"
    faults = campaign(fuzzer, indices, given.jobs, record, failures, given.show or bool(given.only))
    words = collections.Counter(record.verdicts[index].word for index in indices)
    print(f"{len(indices)} inputs of seed {given.seed}: " + ", ".join(f"{number} {word}" for word, number in sorted(words.items())))
    sys.exit(1 if faults else 0)


if __name__ == "__main__":
    main()
