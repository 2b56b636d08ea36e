"""The case swelling_clock in a short form: its check passes beside contacts and in a fluid, and notices what is wrong."""

import unittest

from case_test import CaseTest

BED = {"clock": 100, "readings": 100}
SHEAR = {"scene": "shear", "clock": 1000, "rate": 2e-3, "T": 100, "cells": 32, "readings": 20}


class SwellingClock(CaseTest):
    def test_a_bed(self):
        text = self.passes("", "swelling_clock", **BED)
        self.assertRegex(text, r"swelling was not slow beside contacts: the inertial number \(f_grow\[11\]\) was 0\.\d+, and should be below 0\.02")
        self.fails_with(lambda log: log.replace("was not slow", "was slow"), "log.liggghts", "FAIL  warning given")

    def test_a_sheared_fluid(self):
        text = self.passes("", "swelling_clock", "--np", "2", **SHEAR)
        self.assertRegex(text, r"swelling was not slow beside the flow: .* \(f_grow\[10\]\) was 0\.\d+, and should be below 0\.3")
        self.fails_with_column("against_flow", lambda measure: 1.1 * measure, "FAIL  measure of the flow off its formula")


if __name__ == "__main__":
    unittest.main()
