"""The study of speed against accuracy in its short form; and that the presets which it measures are those of the command `accuracy`."""

import importlib.util
import re
import unittest

import caselib
import case_test
import program

class ShortStudy(case_test.CaseTest):
    def test_runs_once_and_is_judged(self):
        said = self.passes("points = 9", "tradeoff", short=1)
        self.assertIn("9 points, 0 of them finished before", said)
        self.assertRegex(said, r"9/9 bed_\w+: finished, \d+\.\d s; \d:\d\d:\d\d so far, about 0:00:00 left")
        again = self.call(str(caselib.CASES / "run"), "tradeoff", "--out", str(self.folder), "-var", "short", "1", "--check")
        self.assertEqual(again.returncode, 0, again.stdout + again.stderr)
        self.assertIn("9 points, 9 of them finished before", again.stdout)
        self.assertNotIn("running", again.stdout)
        self.fails_with_column("error", lambda error: 0.9, "FAIL  bed: error with 8 cells across", file="points.csv", lines=slice(7, 8))
        self.fails_with(lambda text: text.replace(",finished,", ",failed,", 1), "points.csv", "FAIL  share of the points that failed")


class Presets(program.ProgramTest):
    def test_are_those_of_the_command(self):
        spec = importlib.util.spec_from_file_location("presets", caselib.CASES / "tradeoff" / "presets.py")
        presets = importlib.util.module_from_spec(spec)
        spec.loader.exec_module(presets)
        script = "".join(f"accuracy {name}\n" for name in presets.PRESETS)
        output = self.succeed(script).output
        said = re.findall(r"Accuracy (\w+): points (\d+), cells auto (\d+) across the smallest object, cfl (\S+) ", output)
        self.assertEqual({name: {"points": int(points), "across": int(across), "cfl": float(cfl)} for name, points, across, cfl in said}, presets.PRESETS)


if __name__ == "__main__":
    unittest.main()
