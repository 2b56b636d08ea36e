"""The case swelling_clock in a short form: its check passes beside contacts and in a fluid, and notices what is wrong."""

import unittest

from case_test import CaseTest

BED = ("-var", "clock", "100", "-var", "readings", "100")
SHEAR = ("-var", "scene", "shear", "-var", "clock", "1000", "-var", "rate", "2e-3", "-var", "T", "100", "-var", "cells", "32", "-var", "readings", "20")


class SwellingClock(CaseTest):
    def passes(self, *words):
        result = self.run_case("swelling_clock", *words, "--check")
        self.assertEqual(result.returncode, 0, result.stdout[-2000:] + result.stderr[-2000:])
        return result.stdout

    def change(self, name, old, new):
        file = self.folder / name
        text = file.read_text()
        self.assertIn(old, text)
        file.write_text(text.replace(old, new))

    def test_a_bed(self):
        text = self.passes(*BED)
        self.assertRegex(text, r"swelling was not slow beside contacts: the inertial number \(f_grow\[11\]\) was 0\.\d+, and should be below 0\.02")
        self.change("log.liggghts", "was not slow", "was slow")
        self.check_fails("swelling_clock", "FAIL  warning given")

    def test_a_sheared_fluid(self):
        text = self.passes("--np", "2", *SHEAR)
        self.assertRegex(text, r"swelling was not slow beside the flow: .* \(f_grow\[10\]\) was 0\.\d+, and should be below 0\.3")
        self.change("history.csv", ",0,", ",0,9")  # the last column, energy of the fluid
        self.check_fails("swelling_clock", "FAIL  measure of the flow off its formula")


if __name__ == "__main__":
    unittest.main()
