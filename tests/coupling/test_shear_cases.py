"""The cases of a disc in shear in a short form: their checks pass, however the disc is moved and on several ranks, and notice what is wrong."""

import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import caselib


class ShearCase(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory(prefix="swellflow_")
        self.addCleanup(scratch.cleanup)
        self.folder = Path(scratch.name) / "run"

    def run_case(self, name, short, *words):
        variables = [word for key, value in short.items() for word in ("-var", key, str(value))]
        result = subprocess.run([str(caselib.CASES / "run"), name, "--out", str(self.folder), *variables, *words],
                                stdin=subprocess.DEVNULL, capture_output=True, text=True, timeout=120)
        self.assertEqual(result.returncode, 0, result.stdout[-2000:] + result.stderr[-2000:])
        return result.stdout.splitlines()[-1]

    def notices(self, name, column, change, message):
        """The check of a run whose readings of a column are not what they were."""
        file = self.folder / "disc.csv"
        text = file.read_text()
        lines = [line.split(",") for line in text.splitlines()]
        place = next(k for k, title in enumerate(lines[0]) if title.startswith(column))
        for line in lines[1:]:
            line[place] = repr(change(float(line[place])))
        file.write_text("\n".join(map(",".join, lines)) + "\n")
        result = subprocess.run([sys.executable, str(caselib.CASES / name / "check"), str(self.folder)], stdin=subprocess.DEVNULL, capture_output=True, text=True,
                                timeout=120, env={**os.environ, "PYTHONDONTWRITEBYTECODE": "1"})
        file.write_text(text)
        self.assertEqual(result.returncode, 1, result.stdout + result.stderr)
        self.assertRegex(result.stdout, message)


class ShearRotation(ShearCase):
    SHORT = {"cells": 32, "length": 3, "t_end": 0.6, "readings": 30}

    def test_the_check_passes(self):
        for words in (("--np", "1"), ("--np", "2", "-var", "motion", "implicit"), ("--np", "1", "-var", "motion", "explicit", "-var", "k", "0.5")):
            with self.subTest(words):
                self.assertRegex(self.run_case("shear_rotation", self.SHORT, "--check", *words), r"all conditions hold; turning rate over shear rate = 0\.4")

    def test_the_check_notices_what_is_wrong(self):
        self.run_case("shear_rotation", self.SHORT)
        self.notices("shear_rotation", "rotation", lambda angle: 1.02 * angle, "FAIL  turning rate over shear rate")
        self.notices("shear_rotation", "centroid_y", lambda y: y + 1e-3, "FAIL  way from the middle")


class CouetteMigration(ShearCase):
    SHORT = {"cells": 32, "t_end": 30, "readings": 60, "frames": 1}

    def test_the_check_passes(self):
        for words in (("--np", "1"), ("--np", "2", "-var", "motion", "implicit")):
            with self.subTest(words):
                self.assertRegex(self.run_case("couette_migration", self.SHORT, "--check", *words), r"all conditions hold; y / H at t = 30 H / U = 0\.39")

    def test_the_check_notices_what_is_wrong(self):
        self.run_case("couette_migration", self.SHORT)
        self.notices("couette_migration", "centroid_y", lambda y: y + 0.025, "FAIL  height off the published path")
        self.notices("couette_migration", "area_ratio", lambda ratio: 1.01 * ratio, "FAIL  change of the disc's area")


if __name__ == "__main__":
    unittest.main()
