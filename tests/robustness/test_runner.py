"""cases/run refuses what it cannot do, and says what it can."""

import os
import subprocess
import tempfile
import unittest
from pathlib import Path

import caselib


class Runner(unittest.TestCase):
    case = "cavity_swelling"

    def refused(self, *words, **environment):
        result = subprocess.run([str(caselib.CASES / "run"), *words], env={**os.environ, **environment},
                                stdin=subprocess.DEVNULL, capture_output=True, text=True, timeout=30)
        self.assertNotEqual(result.returncode, 0)
        self.assertNotIn("Traceback", result.stderr)
        return result.stderr

    def test_unknown_case_lists_the_cases(self):
        message = self.refused("no_such_case")
        self.assertIn("unknown case 'no_such_case'", message)
        self.assertIn(self.case, message)

    def test_unknown_variable_lists_the_variables(self):
        message = self.refused(self.case, "-var", "stiffness", "3")
        self.assertIn("no variable 'stiffness'", message)
        for name in caselib.Case(self.case).declared_variables():
            self.assertIn(name, message)

    def test_a_word_that_the_script_does_not_know(self):
        self.assertIn("variable 'flow' of case 'channel' must be pressure or force or flow_rate or inflow or couette or film, but is 'walls'", self.refused("channel", "-var", "flow", "walls"))

    def test_bad_words(self):
        self.assertIn("--np must be", self.refused(self.case, "--np", "0"))
        self.assertIn("not enough arguments for '-var ks'", self.refused(self.case, "-var", "ks"))
        self.assertIn("unknown argument '--fast'", self.refused(self.case, "--fast"))

    def test_program_that_is_not_built(self):
        self.assertIn("./bootstrap build", self.refused(self.case, SWELLFLOW_PROGRAM="/nowhere/swellflow"))

    def test_folder_of_another(self):
        with tempfile.TemporaryDirectory() as folder:
            (Path(folder) / "thesis.txt").write_text("years of work")
            self.assertIn("--out", self.refused(self.case, "--out", folder))
            self.assertTrue((Path(folder) / "thesis.txt").exists())

    def test_a_short_run(self):
        with tempfile.TemporaryDirectory() as folder:
            for steps in ("0.005", "0.01"):  # the second replaces the results of the first
                result = subprocess.run([str(caselib.CASES / "run"), self.case, "--out", folder, "-var", "t_end", steps],
                                        stdin=subprocess.DEVNULL, capture_output=True, text=True, timeout=120)
                self.assertEqual(result.returncode, 0, result.stdout + result.stderr)
            run = caselib.Run(folder)
            self.assertEqual(run.variables["t_end"], 0.01)
            self.assertEqual(run.thermo()[-1]["Step"], 10)


if __name__ == "__main__":
    unittest.main()
