"""A narrow bed: it chokes from above, and its check notices what is wrong."""

import unittest

import caselib
from case_test import CaseTest


class SwellingBed(CaseTest):
    TIMEOUT = 1400  # of a sanitized run

    def test_it_chokes(self):
        self.passes(r"flow at the end over that of the settled bed = 0\.\d+", "swelling_bed", "--np", "2", beads=100, across=10)
        self.assertEqual(len(caselib.read_csv(self.folder / "layers.csv")), 3 * 21)
        at_the_end = slice(-2, None)
        self.fails_with_column("taken_up", lambda mass: 1.01 * mass, "FAIL  uptake of all beads over what the water lost", lines=at_the_end)
        self.fails_with_column("superficial_velocity", lambda u: 10.0 * u, "FAIL  flow at the end over that of the settled bed", lines=at_the_end)


if __name__ == "__main__":
    unittest.main()
