"""Results do not depend on how ranks share the box: two scenes in which objects truly cross, touch and rub on every border (tests/decomposition.py)."""

import tempfile
import unittest
from dataclasses import replace
from pathlib import Path

import caselib
import decomposition
from decomposition import BORDERS, DRIFT, GRIDS, SHEAR, Course, State


class Decomposition(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory(prefix="swellflow_")
        self.addCleanup(scratch.cleanup)
        self.folder = Path(scratch.name)

    def agree(self, scene):
        """On all grids; returns the state of one rank and its course."""
        table = caselib.Table()
        worst = decomposition.compare(table, "scene", scene, self.folder)
        self.assertEqual(table.failed, 0, f"largest difference {worst}: see the lines above")
        alone = State(self.folder / "1x1")
        return alone, Course(alone.objects)

    def rubs(self, scene, state):
        """Without friction, and so without the tangential history that travels with contacts, the scene ends elsewhere."""
        smooth = State(decomposition.run(replace(scene, friction=0.0), GRIDS[0], self.folder / "smooth"))
        self.assertGreater(state.differences(smooth)["position"], 1e-3)

    def touches_on_borders(self, course, axes):
        for axis in axes:
            for border in BORDERS:
                self.assertGreater((course.across(axis, border) & course.touching()).sum(), 50, f"{axis} = {border}")
        corner = course.across("x", 0.5) & course.across("y", 0.5)
        self.assertGreater((corner & course.touching()).sum(), 10, "objects that touch while they lie on four ranks")

    def test_a_stream_across_all_borders(self):
        state, course = self.agree(DRIFT)
        for axis in "xy":
            for border in BORDERS:
                self.assertGreater(course.crossings(axis, border), 10, f"{axis} = {border}")
        self.touches_on_borders(course, "xy")
        self.assertGreater((course.size[-1] / course.size[0]).min(), 1.05)
        self.rubs(DRIFT, state)

    def test_between_sliding_walls(self):
        state, course = self.agree(SHEAR)
        for border in BORDERS:
            self.assertGreater(course.crossings("x", border), 5, f"x = {border}")
        self.touches_on_borders(course, "x")
        self.assertGreater(course.at_walls().sum(), 10)
        self.rubs(SHEAR, state)


if __name__ == "__main__":
    unittest.main()
