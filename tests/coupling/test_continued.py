"""A run that goes on from a restart file equals the one that was not interrupted: to the last bit on the same ranks, to 1e-9 on others.

SWELLFLOW_ALL_RANKS=1 takes every scene to and from 1, 2, 3 and 4 ranks.
"""

import os
import unittest

import numpy as np

from continued import DRY_THERMO, DUMP, EXPLICIT, HARD, MESH, MESH_FILE, MIDDLE, SCENES, SPRINGS, THICK, ContinuedTest, end_of, fluid_in, mesh, resumed, whole

ALL = (1, 2, 3, 4)


class Continued(ContinuedTest):
    timeout = 300 if os.environ.get("SWELLFLOW_ALL_RANKS") else ContinuedTest.timeout

    def check(self, name, continued_on):
        """`continued_on`: on how many ranks, by those that the file is written on."""
        if os.environ.get("SWELLFLOW_ALL_RANKS"):
            continued_on = {ranks: ALL for ranks in ALL}
        return [self.goes_on(name, written_on, others) for written_on, others in continued_on.items()]

    def test_soft_objects_that_swell_in_a_periodic_box(self):
        self.check("soft, swelling, periodic", {1: (1, 2), 4: (4, 2)})

    def test_implicit_and_rigid_objects_and_a_held_flow_rate(self):
        self.check("implicit and rigid, driven", {2: (2, 1)})

    def test_objects_that_push_fluid_away_and_steps_that_are_chosen(self):
        self.check("pushed away, adaptive", {2: (2, 1)})

    def test_objects_that_move_as_told_and_a_scalar(self):
        self.check("held, prescribed, a scalar", {2: (2, 4)})

    def test_no_fluid(self):
        self.check("dry", {1: (1, 2)})

    def test_cut_offs_that_are_widened_on_the_way(self):
        for start, middle, end in self.check("outgrows its cut-offs", {4: (4, 1)}):
            for before, after in ((start, middle), (middle, end)):
                self.assertGreater(after["grow[3]"], 1.1 * before["grow[3]"])

    def test_a_mesh(self):
        for _, middle, end in self.check("on a mesh", {2: (2, 1)}):
            self.assertGreater(min(middle["sums[12]"], end["sums[12]"]), 0.0)

    def test_hubs_without_spokes(self):
        self.check("membranes", {4: (4, 2)})

    def test_lubrication(self):
        for _, middle, end in self.check("lubricated", {1: (1, 4)}):
            self.assertGreater(min(middle["gaps[1]"], end["gaps[1]"]), 0.0)

    def test_a_bed_that_is_fed(self):
        for _, middle, end in self.check("a random bed, fed", {4: (4, 2)}):
            self.assertGreater(end["fresh[7]"], middle["fresh[7]"])
            self.assertGreater(middle["fresh[7]"], 0.0)


class FirstTouch(ContinuedTest):
    """A disc on its way to a mesh; with a file every step one is of the step in which they first meet."""

    STEPS = 40
    LINES = {"boundary": "boundary f f p", "region": THICK, "contact": HARD, "springs": SPRINGS + MESH, "fluid": "", "output": "fix sums all output/objects every 1",
             "objects": "create_objects disk 0.5 0.28 diameter 0.22 points 20 density 2000 cds 0.1 reach 0\nvelocity all set 0.3 -0.6 0 units box",
             "move": EXPLICIT, "thermo": DRY_THERMO.format(" f_sums[12]").replace("thermo 60", "thermo 1")}

    def test_contacts_that_begin_in_the_step_of_a_file(self):
        (self.folder("run") / MESH_FILE).write_text(mesh())
        first = self.succeed(whole(self.LINES, f"restart 1 state.*\nrun {self.STEPS}{DUMP}"))
        unbroken = end_of(first)
        met = next(int(row["Step"]) for row in first.thermo() if row["sums[12]"] > 0)
        again = self.succeed(resumed(self.LINES, f"state.{met}", f"restart 1 later.*\nrun {self.STEPS - met}{DUMP}"))
        self.assertTrue(np.array_equal(unbroken, end_of(again)))


class Between(ContinuedTest):
    def test_a_file_between_runs(self):
        """The run that follows sets up anew, with the file as without it."""
        lines = SCENES["implicit and rigid, driven"]
        run = f"run {MIDDLE}\nwrite_restart middle.restart\nrun {MIDDLE}\nwrite_restart whole.restart"
        first = self.succeed(whole(lines, run), ranks=2)
        self.succeed(resumed(lines, "middle.restart", f"run {MIDDLE}\nwrite_restart end.restart"), ranks=2)
        before, after = fluid_in(first.folder / "whole.restart"), fluid_in(first.folder / "end.restart")
        self.assertEqual([key for key in before if not np.array_equal(before[key], after[key])], [])


if __name__ == "__main__":
    unittest.main(verbosity=2)
