"""Fifty spoilt scripts, tables and restart files: each ends in a clean error or a valid run. `./bootstrap verify fuzz` judges 2,000.

SWELLFLOW_FUZZ_INPUTS=N judges N, SWELLFLOW_FUZZ_SEED=S draws others; what fails is kept where the message says.
"""

import os
import re
import subprocess
import tempfile
import unittest
from pathlib import Path

import caselib
import fuzz
import fuzz_judge

INPUTS = int(os.environ.get("SWELLFLOW_FUZZ_INPUTS", 50))
SEED = int(os.environ.get("SWELLFLOW_FUZZ_SEED", 1))


class Fuzz(unittest.TestCase):
    def test_inputs_end_in_an_error_or_a_run(self):
        scratch = Path(tempfile.mkdtemp(prefix="swellflow_fuzz_"))
        fuzzer = fuzz.Fuzzer(caselib.program(), SEED, scratch / "scratch")
        record = fuzz.Record(scratch, "")
        faults = fuzz.campaign(fuzzer, range(INPUTS), 2, record, scratch / "failures", False)
        words = {verdict.word for verdict in record.verdicts.values()}
        self.assertEqual(faults, [], f"kept in {scratch / 'failures'}")
        self.assertTrue({"refused", "ran"} <= words, "both ends must occur, else the scenes no longer run or no longer are spoilt")
        fuzz.remove(scratch)


class Corpus(unittest.TestCase):
    def test_every_style_and_keyword_of_ours_occurs(self):
        words = {word for scene in fuzz.CORPUS.glob("*/in.script") for word in scene.read_text().split()}
        declared = re.compile(r'options\.(?:number|integer|yes_no|text|choice|flag|list|custom)\("(\w+)"')
        keywords = {name for source in fuzz.HERE.parents[1].glob("liggghts_plugins/*.cpp") for name in declared.findall(source.read_text())}
        self.assertGreater(len(keywords), 50)
        help_text = subprocess.run([caselib.program(), "-log", "none", "-help"], stdout=subprocess.PIPE, text=True, env=caselib.mpi_environment()).stdout
        styles = set(re.findall(r"^  ([\w/]+)$", help_text.split("Command line of swellflow")[0], re.M))
        self.assertIn("fluid/ib", styles)
        self.assertEqual((keywords | styles) - words, set(), "add them to a scene of tests/robustness/corpus")


class Judge(unittest.TestCase):
    """What the judge has to see, shown to it."""

    def judged(self, body, code="exit 0", limit=2):
        folder = tempfile.TemporaryDirectory(prefix="swellflow_judge_")
        self.addCleanup(folder.cleanup)
        program, place = Path(folder.name) / "program", Path(folder.name) / "place"
        program.write_text(f"#!/bin/bash\n{body}\n{code}\n")
        program.chmod(0o755)
        (place / "run").mkdir(parents=True)
        return fuzz_judge.Judge(program, limit)(place, 1)

    def assert_fault(self, verdict, word):
        self.assertEqual(verdict.word, "fault")
        self.assertIn(word, verdict.detail)

    def test_good_ends(self):
        self.assertEqual(self.judged("").word, "ran")
        self.assertEqual(self.judged("echo 'ERROR: a rule, but a value: a remedy'", "exit 1").word, "refused")
        self.assertEqual(self.judged("trap 'exit 0' USR2; while true; do sleep 0.1; done").word, "long")

    def test_faults(self):
        self.assert_fault(self.judged("kill -SEGV $$"), "crashes")
        self.assert_fault(self.judged("", "exit 1"), "without a message")
        self.assert_fault(self.judged("echo ERROR: no"), "exit code 0")
        self.assert_fault(self.judged("echo ERROR: no; echo ERROR: no", "exit 1"), "2 messages")
        self.assert_fault(self.judged("echo ERROR: vector::_M_default_append", "exit 1"), "says nothing")
        self.assert_fault(self.judged("echo '==1==ERROR: AddressSanitizer: heap-use-after-free'", "exit 99"), "sanitizer")
        self.assert_fault(self.judged("echo x > ../y"), "outside")
        self.assert_fault(self.judged("echo x > ../beside"), "outside")
        self.assert_fault(self.judged("printf 'Step Time \\n 1 -nan \\nLoop time of\\n' > log.liggghts"), "thermo")
        self.assert_fault(self.judged("printf 'step,a\\n1,nan\\n' > a.csv"), "a.csv")
        self.assert_fault(self.judged("trap '' USR2; for ((;;)); do sleep 0.1; done", limit=1), "hangs")


if __name__ == "__main__":
    unittest.main()
