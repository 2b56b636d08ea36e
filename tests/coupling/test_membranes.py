"""The cases of objects without spokes, elastic_ring and capsule, in a short form: their checks pass, in other units and on two ranks, and notice what is wrong."""

import json
import math
import unittest

import numpy as np

import caselib
import ellipses
from case_test import CaseTest

RING = ("elastic_ring", "-var", "across", "6", "-var", "box", "12", "-var", "t_end", "1")
CAPSULE = ("capsule", "-var", "across", "6", "-var", "t_end", "0.5", "-var", "Ca", "0.1")


class Membranes(CaseTest):
    def passes(self, *words):
        result = self.run_case(*words, "--check")
        self.assertEqual(result.returncode, 0, result.stdout[-3000:] + result.stderr[-2000:])
        self.assertRegex(result.stdout.splitlines()[-1], "all conditions hold; largest error of")

    def fails_when_taken_for(self, case, name, value, message):
        """When the check is told of another value than the run had."""
        file = self.folder / caselib.RUN_FILE
        text = file.read_text()
        record = json.loads(text)
        record["variables"][name] = value
        file.write_text(json.dumps(record))
        self.check_fails(case, message)
        file.write_text(text)

    def test_elastic_ring(self):
        self.passes(*RING, "--np", "2", "-var", "mu", "5", "-var", "kappa", "0.2")
        self.fails_when_taken_for("elastic_ring", "kappa", "1.4", "FAIL  largest error of a semi-axis")

    def test_capsule(self):
        self.passes(*CAPSULE, "--np", "2", "-var", "shear", "3", "-var", "R", "0.1")
        self.fails_when_taken_for("capsule", "Ca", "0.01", "FAIL  largest error of D")
        self.fails_when_taken_for("capsule", "shear", "4", "FAIL  largest error of the published angle")


class Ellipses(unittest.TestCase):
    def test_corners_on_an_ellipse_give_its_axes(self):
        for angle in (0.0, 0.4, -1.2):
            theta = 2 * math.pi * np.arange(50) / 50
            x, y = 2.0 * np.cos(theta), 0.7 * np.sin(theta)
            corners = np.array([3.0 + x * math.cos(angle) - y * math.sin(angle), -5.0 + x * math.sin(angle) + y * math.cos(angle)]).T
            found, share = ellipses.of_polygon(corners), ellipses.inscribed(50)
            self.assertAlmostEqual(found.area, share * math.pi * 2.0 * 0.7, 12)
            self.assertAlmostEqual(found.angle, angle, 12)
            self.assertAlmostEqual(found.long / found.short, 2.0 / 0.7, 12)
            self.assertAlmostEqual(found.deformation, 1.3 / 2.7, 12)
            self.assertAlmostEqual(found.long / 2.0, 1.0, delta=2 * (1 - share))
            self.assertAlmostEqual(found.x, 3.0, 12)
            self.assertAlmostEqual(found.y, -5.0, 12)


if __name__ == "__main__":
    unittest.main()
