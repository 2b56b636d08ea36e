"""The case of discs at random places in a short form: its check passes on one rank and on several, and notices what is wrong."""

import sys
import unittest

import numpy as np

import caselib
from case_test import CaseTest

sys.path.insert(0, str(caselib.CASES / "random_array"))
import exact  # noqa: E402


class RandomArray(CaseTest):
    def permeability(self, *words, **variables):
        said = self.passes(r"permeability / D\^2 = ", "random_array", *words, discs=12, cells=14, **variables)
        return float(said.split()[-1])

    def test_ranks_make_no_difference_and_seeds_do(self):
        one = self.permeability()
        self.assertAlmostEqual(self.permeability("--np", "2"), one, delta=1e-6 * one)
        self.assertGreater(abs(self.permeability(seed=2) - one), 0.02 * one)

    def test_the_check_notices_what_is_wrong(self):
        self.permeability()
        self.fails_with_column("mean_x", lambda u: 1.3 * u, "FAIL  permeability")
        self.fails_with_column("drag", lambda F: 1.01 * F, "FAIL  force on the discs")
        self.fails_with_column("centroid_x", lambda x: 0.75 * x, "FAIL  (permeability|that across the drive)", file="objects.csv")


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
