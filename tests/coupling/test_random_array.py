"""The case of discs at random places in a short form: its check passes on one rank and on several, and notices what is wrong."""

import re
import sys
import unittest

import numpy as np

import caselib
from case_test import CaseTest

sys.path.insert(0, str(caselib.CASES / "random_array"))
import exact  # noqa: E402


class RandomArray(CaseTest):
    SHORT = ("-var", "discs", "12", "-var", "cells", "14")

    def permeability(self, *words):
        result = self.run_case("random_array", "--check", *self.SHORT, *words)
        self.assertEqual(result.returncode, 0, result.stdout[-2000:] + result.stderr[-2000:])
        return float(re.search(r"all conditions hold; permeability / D\^2 = (\S+)", result.stdout)[1])

    def test_ranks_make_no_difference_and_seeds_do(self):
        one = self.permeability()
        self.assertAlmostEqual(self.permeability("--np", "2"), one, delta=1e-6 * one)
        self.assertGreater(abs(self.permeability("-var", "seed", "2") - one), 0.02 * one)

    def test_the_check_notices_what_is_wrong(self):
        self.permeability()
        history, places = self.folder / "history.csv", self.folder / "objects.csv"
        for file, column, change, message in ((history, "mean_x", lambda u: 1.3 * u, "FAIL  permeability"), (history, "drag", lambda F: 1.01 * F, "FAIL  force on the discs"),
                                              (places, "centroid_x", lambda x: 0.75 * x, "FAIL  (permeability|that across the drive)")):
            text = file.read_text()
            lines = [line.split(",") for line in text.splitlines()]
            place = next(k for k, title in enumerate(lines[0]) if title.startswith(column))
            for line in lines[1:]:
                line[place] = repr(change(float(line[place])))
            file.write_text("\n".join(map(",".join, lines)) + "\n")
            self.check_fails("random_array", message)
            file.write_text(text)


class Exact(unittest.TestCase):
    def test_square_arrays_are_those_of_sangani_and_acrivos(self):
        places = np.array([[0.1 + i, 0.2 + j] for i in range(3) for j in range(3)])
        for row in caselib.read_csv(caselib.CASES / "square_array" / "reference.csv"):
            if row["phi"] > 0.5:
                continue
            tensor = exact.permeability(places, np.sqrt(row["phi"] / np.pi), 3.0)
            self.assertAlmostEqual(1.0 / tensor[0, 0], row["exact"], delta=1e-6 * row["exact"])
            self.assertAlmostEqual(tensor[1, 1], tensor[0, 0], delta=1e-9 * tensor[0, 0])
            self.assertLess(abs(tensor[0, 1]), 1e-9 * tensor[0, 0])


if __name__ == "__main__":
    unittest.main()
