"""The case of dye in a channel in a short form: its check passes, both ways and on several ranks, and notices what is wrong."""

import unittest

from case_test import CaseTest

SHORT = {"cells": 12, "t_end": 0.5, "shown": 10}


class TaylorDispersion(CaseTest):
    def test_the_check_passes(self):
        for ranks, variables in (("1", {}), ("4", {"along": "y", "pe": 10})):
            with self.subTest(ranks=ranks, **variables):
                self.passes("dispersion coefficient over D = ", "taylor_dispersion", "--np", ranks, **SHORT, **variables)

    def test_the_check_notices_what_is_wrong(self):
        self.run_case("taylor_dispersion", **SHORT)
        self.fails_when_taken_for("FAIL  variance on the way", pe=25)
        self.fails_with_column("largest", lambda value: 1.01, "FAIL  dye below none or above all", lines=slice(1))


if __name__ == "__main__":
    unittest.main()
