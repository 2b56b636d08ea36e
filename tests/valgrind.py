#!/usr/bin/python3
"""valgrind.py BUILD: the unit tests and coupled runs of a build under valgrind's memcheck, on 1 and 2 ranks; prints a line a run and fails when there are errors.

What Open MPI does itself is left out, by its own file and tests/valgrind.supp. The build must be for any processor (SWELLFLOW_NATIVE=OFF).
"""

import os
import shutil
import subprocess
import sys
import tempfile
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

sys.dont_write_bytecode = True
TESTS = Path(__file__).resolve().parent
sys.path.insert(0, str(TESTS.parent / "cases"))
import caselib  # noqa: E402

MEMCHECK = ["valgrind", "--quiet", "--error-exitcode=99", "--track-origins=yes", "--num-callers=30", "--suppressions=/usr/share/openmpi/openmpi-valgrind.supp", f"--suppressions={TESTS / 'valgrind.supp'}"]
SCENES = TESTS / "robustness" / "corpus"
RUNS = ("cavity", "stream", "grains", "stirrer", "capsule", "laws", "warm", ("saved", "resumed"))  # a pair: the second reads what the first has written


def checked(name, command, ranks, folder):
    """Runs a command under memcheck; whether it found nothing, after a line that says so."""
    start = time.monotonic()
    run = subprocess.run(["mpirun", "--oversubscribe", "-np", str(ranks), *MEMCHECK, *command], cwd=folder, env=caselib.mpi_environment(), stdin=subprocess.DEVNULL,
                         stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, errors="replace")
    print(f"{'clean' if run.returncode == 0 else 'ERRORS'}  {name} on {ranks} rank(s), {time.monotonic() - start:.0f} s", flush=True)
    if run.returncode != 0:
        print(run.stdout[-6000:], flush=True)
    return run.returncode == 0


def unit_test(program, ranks):
    return checked(program.name, [str(program)], ranks, program.parent)


def scenes(program, run, ranks):
    """A scene, or two of which the second goes on from the first, in a folder of its own."""
    with tempfile.TemporaryDirectory(prefix="swellflow_valgrind_") as folder:
        good = True
        for scene in (run,) if isinstance(run, str) else run:
            shutil.copytree(SCENES / scene, folder, dirs_exist_ok=True)
            good = good and checked(scene, [str(program), "-in", "in.script"], ranks, folder)
        return good


def main(build):
    unit = sorted(path for path in (build / "tests" / "unit").glob("test_*") if path.is_file() and os.access(path, os.X_OK))
    program = build / "coupling" / "swellflow"
    jobs = [lambda p=path, n=ranks: unit_test(p, n) for path in unit for ranks in (1, 2)]
    jobs += [lambda r=run, n=ranks: scenes(program, r, n) for run in RUNS for ranks in (1, 2)]
    with ThreadPoolExecutor(max(1, (os.cpu_count() or 1) // 2)) as pool:
        results = list(pool.map(lambda job: job(), jobs))
    print(f"{sum(results)} of {len(results)} clean")
    sys.exit(0 if results and all(results) else 1)


if __name__ == "__main__":
    main(Path(sys.argv[1]).absolute())
