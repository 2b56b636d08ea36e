"""A narrow bed: it chokes from above, and its check notices what is wrong."""

import unittest

import caselib
from case_test import CaseTest


class SwellingBed(CaseTest):
    TIMEOUT = 400

    def test_it_chokes(self):
        result = self.run_case("swelling_bed", "-var", "beads", "100", "-var", "across", "10", "--np", "2", "--check")
        self.assertEqual(result.returncode, 0, result.stdout[-3000:] + result.stderr[-2000:])
        self.assertRegex(result.stdout.splitlines()[-1], r"all conditions hold; flow at the end over that of the settled bed = 0\.\d+")
        self.assertEqual(len(caselib.read_csv(self.folder / "layers.csv")), 3 * 21)
        self.wrong("taken_up", 1.01, "FAIL  uptake of all beads over what the water lost")
        self.wrong("superficial_velocity", 1.6, "FAIL  flow at the end over that of the settled bed")

    def wrong(self, column, factor, message):
        """In the last lines of the history."""
        file = self.folder / "history.csv"
        text = file.read_text()
        lines = [line.split(",") for line in text.splitlines()]
        place = lines[0].index(column)
        for line in lines[-2:]:
            line[place] = str(factor * float(line[place]))
        file.write_text("\n".join(",".join(line) for line in lines) + "\n")
        self.check_fails("swelling_bed", message)
        file.write_text(text)


if __name__ == "__main__":
    unittest.main()
