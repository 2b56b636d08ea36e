"""What goes wrong while a run goes on ends it on all ranks, once, with what happened and a restart file to go on from; and how exact a run was is told in one table.

Limits that are known before the first step are rows of test_bad_input.py.
"""

import re
import unittest

from program import ProgramTest
from scene import LINES, scene

FIRST_OBJECT = "region first block 0.1 0.5 0.1 0.5 -1 1 units box\ngroup first region first\n"
MIRRORED = FIRST_OBJECT + "displace_atoms first ramp x 0.4 -0.4 x 0.1 0.5 units box\n"
PRESSED = FIRST_OBJECT + "displace_atoms first ramp x 0.19 -0.19 x 0.1 0.5 units box\n"  # to a twentieth of its width
DRY = {"fluid": "", "output": "", "swell": "", "thermo": "thermo 50"}
# From step 14 on.
INFINITE_FORCE = "variable push equal exp(1000*(step>13))\nfix push first addforce v_push 0 0\n"
FLUID_ALONE = {"objects": "", "springs": "", "swell": "", "move": "", "output": "", "contact": "", "pair": "", "neighbor": "neighbor 0.01 bin", "thermo": "thermo 50",
               "region": LINES["region"].replace("-0.005 0.005", "-0.02 0.02")}
# The lid's velocity is 0 at first and soon one whose square is no number any more.
LID = LINES["fluid"].replace("velocity 0.1 0", "velocity v_lid 0")

SOFT_CONTACTS = LINES["contact"].replace("kn peratomtypepair 1 1e4", "kn peratomtypepair 1 10").replace("kt peratomtypepair 1 1e4", "kt peratomtypepair 1 10")
# A rigid disc so heavy, and fluid steps so long, that the fluid never comes up with it.
SLIPPING = {"objects": "create_objects disk 0.5 0.8 diameter 0.2 points 16 density 1e6 cds 0.2", "springs": "", "swell": "", "output": "",
            "move": "fix move all rigid/cds\nfix flat all enforce2d\nfix weight all gravity 1e-3 vector 0 -1 0",
            "fluid": "fix water all fluid/ib cells 32 32 density 1000 viscosity 1e-1 every 20", "timestep": "timestep 2e-2", "thermo": "thermo 200", "run": "run 1100"}

ENDS = [
    ("not a number, dry", {**DRY, "run": FIRST_OBJECT + INFINITE_FORCE + "restart 10 state.*\nrun 200"},
     ["finite", "object (molecule) 1", "infinite or not a number at step", "'state.10'"]),
    ("not a number in a fluid", {"run": FIRST_OBJECT + INFINITE_FORCE + "restart 10 state.*\nrun 50"},
     ["must be finite", "object (molecule) 1", "infinite or not a number at step 14", "'state.10'"]),
    ("inside out", {**DRY, "run": MIRRORED + "run 50"}, ["must not turn inside out", "object (molecule) 1 has -1 of its natural area at step", "stiffer springs", "no restart file", "guard warn"]),
    ("crushed", {"run": PRESSED + "run 50"}, ["must stay there", "object (molecule) 1 is crushed to 0.0", "of its area at step 2", "stiffer springs", "guard warn"]),
    ("runaway", {"run": FIRST_OBJECT + "restart 4 state.*\nrun 4\nvelocity first set 500 0 0\nrun 50"},
     ["near enough", "object (molecule) 1 moves by", "radii of it in a fluid step at step 5", "'state.4'", "guard warn"]),
    ("within each other", {**DRY, "contact": SOFT_CONTACTS, "run": FIRST_OBJECT + "velocity first set 0.5 0 0\nrestart 500 state.*\nrun 2000"},
     ["must not pass into each other", "the middle of another lies within object (molecule)", "at step 6", "stiffer contacts", "'state.500'", "guard warn"]),
    ("slip of rigid objects", SLIPPING, ["guard: the share of fluid steps in which the slip at the outlines of rigid objects is beyond 0.05", "at most 0.5, but is", "at step 1100", "'every'", "guard warn"]),
    ("lost", {**DRY, "run": FIRST_OBJECT + "velocity first set -5 0 0\nrestart 10 state.*\nrun 200"}, ["must keep all its points", "object (molecule) 1 has lost one at step", "'state."]),
    ("flow", {**FLUID_ALONE, "fluid": "variable lid equal step*1e99\nguard off\n" + LID, "run": "restart 2 state.*\nrun 50"}, ["velocity must stay finite", "'state.4'"]),
    ("flow that runs away", {**FLUID_ALONE, "fluid": "variable lid equal step*1e3\n" + LID.replace("viscosity 1e-2", "viscosity 1e6"), "run": "run 100"}, ["CFL number must be at most 50", "the flow as it is, fix water at step 40"]),
]

OVERRIDDEN = {"inside out": "must not turn inside out", "contacts": "longest with which contacts are stable"}


class Guard(ProgramTest):
    def ends(self, ranks):
        for name, change, words in ENDS:
            with self.subTest(name, ranks=ranks):
                result = self.run_program(scene(**change), ranks=ranks, name=f"{name} {ranks}".replace(" ", "_"))
                self.assertNotEqual(result.status, 0, "the run went on:\n" + result.output[-1500:])
                self.assertNotRegex(result.output, "Segmentation|terminate called|assert", "it crashed")
                messages = [line for line in result.output.splitlines() if line.startswith("ERROR")]
                self.assertEqual(len(messages), 1, result.output[-1500:])
                for word in words:
                    self.assertIn(word, messages[0])
                self.assertNotRegex(result.output.split("ERROR")[0].split("Step")[-1], r"(?i)\b-?(nan|inf)\b", "what is no number was printed as a result")

    def test_1_rank(self):
        self.ends(1)

    def test_2_ranks(self):
        self.ends(2)

    def test_4_ranks(self):
        self.ends(4)

    def test_warn_and_off(self):
        scenes = {"inside out": {**DRY, "run": MIRRORED + "run 50"},
                  "contacts": {**DRY, "contact": LINES["contact"].replace("kn peratomtypepair 1 1e4", "kn peratomtypepair 1 1e9"), "run": "run 50"}}
        for name, change in scenes.items():
            for mode, expected in (("warn", 1), ("off", 0)):
                with self.subTest(name, mode=mode):
                    result = self.succeed(scene(**{**change, "timestep": f"timestep 1e-3\nguard {mode}"}), ranks=2, name=f"{name} {mode}".replace(" ", "_"))
                    self.assertEqual(len(re.findall("WARNING.*" + OVERRIDDEN[name], result.output)), expected, result.output[-2000:])

    def test_what_is_no_number_ends_a_run_also_without_a_guard(self):
        name, change, words = ENDS[0]
        result = self.run_program(scene(**{**change, "timestep": "timestep 1e-3\nguard off"}), ranks=2)
        self.assertNotEqual(result.status, 0)
        self.assertIn(words[0], result.output)

    def test_refused_again_when_the_step_grows_without_a_set_up(self):
        stiff = {**DRY, "springs": LINES["springs"].replace("1000", "1e5")}
        result = self.run_program(scene(**stiff, run="run 10\ntimestep 1e-2\nrun 10 pre no"))
        self.assertNotEqual(result.status, 0)
        self.assertIn("springs are stable must be at most 1", result.output)
        self.assertIn("at step 11", result.output)


class Budget(ProgramTest):
    @staticmethod
    def lines(result):
        """name -> (value, word) of the last table."""
        table = result.log.split("Accuracy of the run")[-1]
        return {name.strip(): (float(value), word) for name, value, word in re.findall(r"^  (.+?)  +([-+.\deinfa]+) +\S+ +\S+ +(fine|watch|poor)$", table, re.M)}

    def budget(self, name, ranks=1, **changes):
        result = self.succeed(scene(**{"output": "", "run": "run 40", **changes}), ranks=ranks, name=name)
        return result, self.lines(result)

    def test_all_is_fine_on_any_ranks(self):
        tables = []
        for ranks in (1, 2, 4):
            result, lines = self.budget(f"fine_{ranks}", ranks)
            self.assertEqual({word for value, word in lines.values()}, {"fine"}, lines)
            self.assertIn("  All is fine.", result.output)
            self.assertEqual(result.output.count("Accuracy of the run"), 1)
            tables.append(lines)
        for lines in tables[1:]:
            self.assertEqual(lines.keys(), tables[0].keys())
            for name, (value, _) in lines.items():
                self.assertLessEqual(abs(value - tables[0][name][0]), 1e-3 * abs(value) + 1e-12, name)

    def test_a_knob_made_bad_makes_its_line_poor_and_names_a_remedy(self):
        sparse = LINES["objects"].replace("points 16", "points 8")
        for name, line, remedy, changes in (
                ("markers", "distance of markers / cell", "'marker_gap'", {"objects": sparse, "fluid": LINES["fluid"] + " marker_gap 10"}),
                ("springs", "time step over the longest with which springs are stable", "nve/cds implicit", {"springs": LINES["springs"].replace("1000", "1.45e6"), "fluid": "", "thermo": "thermo 50"}),
                ("contacts", "time step over the longest with which contacts are stable", "contacts softer",
                 {"contact": LINES["contact"].replace("kn peratomtypepair 1 1e4", "kn peratomtypepair 1 1e6")}),
                ("clock", "speed of swelling / that which the flow can follow", "'clock'", {"swell": LINES["swell"] + " clock 400"})):
            with self.subTest(name):
                result, lines = self.budget(name, **changes)
                self.assertIn(lines[line][1], ("poor", "watch"), lines)
                self.assertIn("Worst is the " + line, result.output)
                self.assertRegex(result.output, f"Worst is .*{remedy}")

    def test_slip_is_measured_against_outlines_that_grow_in_a_fluid_at_rest(self):
        _, lines = self.budget("at_rest", fluid=LINES["fluid"].replace("velocity 0.1 0", "velocity 0 0"))
        self.assertLess(lines["slip at outlines / speed"][0], 0.05, lines)

    def test_only_what_a_scene_has_and_only_with_the_post_part(self):
        result, lines = self.budget("dry", fluid="", swell="", thermo="thermo 5", run="run 5\nrun 5 pre no post no\nrun 5 pre no")
        self.assertEqual(set(lines), {"time step over the longest with which springs are stable", "time step over the longest with which contacts are stable"})
        self.assertEqual(result.output.count("Accuracy of the run"), 2)
        result, lines = self.budget("fluid_alone", **FLUID_ALONE)
        self.assertEqual(set(lines), {"CFL number", "divergence, cells x divergence / speed"})


if __name__ == "__main__":
    unittest.main()
