"""The cases of a disc in shear in a short form: their checks pass, however the disc is moved and on several ranks, and notice what is wrong."""

import unittest

from case_test import CaseTest


class ShearRotation(CaseTest):
    SHORT = {"cells": 32, "length": 3, "t_end": 0.6, "readings": 30}

    def test_the_check_passes(self):
        for ranks, variables in (("1", {}), ("2", {"motion": "implicit"}), ("1", {"motion": "explicit", "k": 0.5})):
            with self.subTest(ranks=ranks, **variables):
                self.passes(r"turning rate over shear rate = 0\.4", "shear_rotation", "--np", ranks, **self.SHORT, **variables)

    def test_the_check_notices_what_is_wrong(self):
        self.run_case("shear_rotation", **self.SHORT)
        self.fails_with_column("rotation", lambda angle: 1.02 * angle, "FAIL  turning rate over shear rate", file="disc.csv")
        self.fails_with_column("centroid_y", lambda y: y + 1e-3, "FAIL  way from the middle", file="disc.csv")


class CouetteMigration(CaseTest):
    SHORT = {"cells": 32, "t_end": 30, "readings": 60, "frames": 1}

    def test_the_check_passes(self):
        for ranks, variables in (("1", {}), ("2", {"motion": "implicit"})):
            with self.subTest(ranks=ranks, **variables):
                self.passes(r"y / H at t = 30 H / U = 0\.39", "couette_migration", "--np", ranks, **self.SHORT, **variables)

    def test_the_check_notices_what_is_wrong(self):
        self.run_case("couette_migration", **self.SHORT)
        self.fails_with_column("centroid_y", lambda y: y + 0.025, "FAIL  height off the published path", file="disc.csv")
        self.fails_with_column("area_ratio", lambda ratio: 1.01 * ratio, "FAIL  change of the disc's area", file="disc.csv")


if __name__ == "__main__":
    unittest.main()
