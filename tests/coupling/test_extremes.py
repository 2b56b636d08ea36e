"""The map of the extremes in its short form: points that are right, refused and ended, and a check that finds what is wrong, missing or refused too often."""

import unittest

import caselib
import case_test


class ShortMap(case_test.CaseTest):
    def test_ends_as_it_should_and_is_judged(self):
        said = self.passes("wrong = 0 of 12 points", "extremes", short=1)
        self.assertRegex(said, r"\n      right: 7\n      refused: 3\n      ended: 2\n      wrong: 0\n")
        for ending, message in (("wrong", "FAIL  points that are wrong"), ("refused", "FAIL  share of those that are right")):
            self.fails_with(lambda text, ending=ending: text.replace(",right,", f",{ending},", 3), "points.csv", message)
        self.fails_with(lambda text: text[:text.rstrip().rfind("\n") + 1], "points.csv", "FAIL  points that were not run")
        self.breaks_a_bound()

    def breaks_a_bound(self):
        """A run in the folder, which is judged anew, by a history in which the fluid has twice its energy."""
        history = self.folder / "stream_explicit_base" / "history.csv"
        titles, *rows = [line.split(",") for line in history.read_text().splitlines()]
        for row in rows:
            row[titles.index("fluid_energy")] = repr(2 * float(row[titles.index("fluid_energy")]))
        history.write_text("\n".join(map(",".join, [titles, *rows])) + "\n")
        judged = self.call(str(caselib.CASES / "run"), "extremes", "--out", str(self.folder), "-var", "short", "1", "--check")
        self.assertEqual(judged.returncode, 1, judged.stdout + judged.stderr)
        self.assertIn("12 points, 12 of them finished before", judged.stdout)
        self.assertRegex(judged.stdout, "wrong: stream_explicit_base: energy over that of the start 1")


if __name__ == "__main__":
    unittest.main()
