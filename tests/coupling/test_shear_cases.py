"""The cases of a disc in shear in a short form: their checks pass, however the disc is moved and on several ranks, and notice what is wrong."""

import unittest

from case_test import CaseTest


class ShearCase(CaseTest):
    def last_line(self, name, *words):
        variables = [word for key, value in self.SHORT.items() for word in ("-var", key, str(value))]
        result = self.run_case(name, *variables, *words)
        self.assertEqual(result.returncode, 0, result.stdout[-2000:] + result.stderr[-2000:])
        return result.stdout.splitlines()[-1]

    def notices(self, name, column, change, message):
        """The check of a run whose readings of a column are not what they were."""
        file = self.folder / "disc.csv"
        text = file.read_text()
        lines = [line.split(",") for line in text.splitlines()]
        place = next(k for k, title in enumerate(lines[0]) if title.startswith(column))
        for line in lines[1:]:
            line[place] = repr(change(float(line[place])))
        file.write_text("\n".join(map(",".join, lines)) + "\n")
        self.check_fails(name, message)
        file.write_text(text)


class ShearRotation(ShearCase):
    SHORT = {"cells": 32, "length": 3, "t_end": 0.6, "readings": 30}

    def test_the_check_passes(self):
        for words in (("--np", "1"), ("--np", "2", "-var", "motion", "implicit"), ("--np", "1", "-var", "motion", "explicit", "-var", "k", "0.5")):
            with self.subTest(words):
                self.assertRegex(self.last_line("shear_rotation", "--check", *words), r"all conditions hold; turning rate over shear rate = 0\.4")

    def test_the_check_notices_what_is_wrong(self):
        self.last_line("shear_rotation")
        self.notices("shear_rotation", "rotation", lambda angle: 1.02 * angle, "FAIL  turning rate over shear rate")
        self.notices("shear_rotation", "centroid_y", lambda y: y + 1e-3, "FAIL  way from the middle")


class CouetteMigration(ShearCase):
    SHORT = {"cells": 32, "t_end": 30, "readings": 60, "frames": 1}

    def test_the_check_passes(self):
        for words in (("--np", "1"), ("--np", "2", "-var", "motion", "implicit")):
            with self.subTest(words):
                self.assertRegex(self.last_line("couette_migration", "--check", *words), r"all conditions hold; y / H at t = 30 H / U = 0\.39")

    def test_the_check_notices_what_is_wrong(self):
        self.last_line("couette_migration")
        self.notices("couette_migration", "centroid_y", lambda y: y + 0.025, "FAIL  height off the published path")
        self.notices("couette_migration", "area_ratio", lambda ratio: 1.01 * ratio, "FAIL  change of the disc's area")


if __name__ == "__main__":
    unittest.main()
