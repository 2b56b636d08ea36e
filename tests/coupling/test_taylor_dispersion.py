"""The case of dye in a channel in a short form: its check passes, both ways and on several ranks, and notices what is wrong."""

import json
import unittest

import caselib
from case_test import CaseTest

SHORT = ("taylor_dispersion", "-var", "cells", "12", "-var", "t_end", "0.5", "-var", "shown", "10")


class TaylorDispersion(CaseTest):
    def test_the_check_passes(self):
        for words in (("--np", "1"), ("--np", "4", "-var", "along", "y", "-var", "pe", "10")):
            with self.subTest(words):
                result = self.run_case(*SHORT, *words, "--check")
                self.assertEqual(result.returncode, 0, result.stdout[-2000:] + result.stderr[-2000:])
                self.assertRegex(result.stdout.splitlines()[-1], "all conditions hold; dispersion coefficient over D = ")

    def test_the_check_notices_what_is_wrong(self):
        self.run_case(*SHORT)
        file = self.folder / caselib.RUN_FILE
        text = file.read_text()
        record = json.loads(text)
        record["variables"]["pe"] = "25"
        file.write_text(json.dumps(record))
        self.check_fails("taylor_dispersion", "FAIL  variance on the way")
        file.write_text(text)
        history = self.folder / "history.csv"
        history.write_text(history.read_text().replace("\n", "\n0,0,0,1.01,0\n", 1))
        self.check_fails("taylor_dispersion", "FAIL  dye below none or above all")


if __name__ == "__main__":
    unittest.main()
