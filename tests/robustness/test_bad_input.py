"""Bad input ends before any step, on every number of ranks, with one message: rule, value, place and remedy.

A row is a name, the changed line of the scene and what the message must say, in this order: place, rule, value, remedy.
What shows during a run only ends in the same way.
"""

import re
import unittest

from program import ProgramTest
from scene import LINES, moved, scene


def with_word(line, old, new):
    assert old in LINES[line], (line, old)
    return {line: LINES[line].replace(old, new)}


def dry(**changes):
    """The scene without a fluid and what needs one."""
    return {"fluid": "", "output": "", "swell": "", "thermo": "thermo 5", **changes}


ROWS = [
    ("unknown keyword", with_word("springs", "restitution", "restitutoin"),
     ["fix springs mass_spring", "unknown keyword", "'restitutoin'", "stiffness"]),
    ("unknown keyword of the fluid", with_word("fluid", "every", "evry"), ["fix water fluid/ib", "unknown keyword", "'evry'", "every"]),
    ("unknown keyword of the output", with_word("output", "folder", "dir"), ["fix out output/vtk", "unknown keyword", "'dir'", "folder"]),
    ("unknown keyword of the objects", with_word("objects", "density", "densty"), ["create_objects", "unknown keyword", "'densty'", "density"]),
    ("unknown style", with_word("fluid", "fluid/ib", "fluid/bi"), ["Invalid fix style", "fluid/bi"]),
    ("missing argument", {"springs": "fix springs all mass_spring stiffness"},
     ["fix springs mass_spring", "not enough arguments", "'stiffness'", "give"]),
    ("missing argument of the fluid", {"fluid": "fix water all fluid/ib cells 32"},
     ["fix water fluid/ib", "not enough arguments", "'cells'", "give"]),
    ("missing keyword", {"fluid": "fix water all fluid/ib cells 32 32 viscosity 1e-2"},
     ["fix water fluid/ib", "'density' is missing", "add"]),
    ("keyword given twice", with_word("springs", "restitution 1.0", "stiffness 2"),
     ["fix springs mass_spring", "'stiffness' is given twice", "keep one"]),
    ("not a number", with_word("springs", "1000", "1000x"), ["fix springs mass_spring", "'stiffness' must be", "'1000x'", "change"]),
    ("infinite number", with_word("springs", "1000", "inf"), ["fix springs mass_spring", "'stiffness' must be", "'inf'", "change"]),
    ("NaN", with_word("fluid", "1e-2", "nan"), ["fix water fluid/ib", "'viscosity' must be", "'nan'", "change"]),
    ("negative density", with_word("objects", "1500", "-1500"), ["create_objects", "'density' must be", "'-1500'", "change"]),
    ("negative diameter", with_word("objects", "diameter 0.2", "diameter -0.2"), ["create_objects", "'diameter' must be", "'-0.2'", "change"]),
    ("negative density of the fluid", with_word("fluid", "density 1000", "density -1"),
     ["fix water fluid/ib", "'density' must be", "'-1'", "change"]),
    ("zero steps", with_word("fluid", "every 2", "every 0"), ["fix water fluid/ib", "'every' must be", "'0'", "change"]),
    ("restitution above 1", with_word("springs", "1.0", "1.5"), ["fix springs mass_spring", "'restitution' must be", "'1.5'", "change"]),
    ("too few ring points", with_word("objects", "points 16", "points 2"), ["create_objects", "'points' must be", "'2'", "change"]),
    ("object outside the box", with_word("objects", "0.3 0.3", "0.05 0.3"), ["create_objects", "inside the box", "(0.05, 0.3)", "move"]),
    ("objects overlap", with_word("objects", "spacing 0.4", "spacing 0.19"), ["create_objects", "must not overlap", "0.01", "move"]),
    ("CDS larger than its object", with_word("objects", "cds 0.2", "cds 0.6"), ["create_objects", "'cds' must be", "'0.6'", "change"]),
    ("type that the box does not have", with_word("objects", "type 1", "type 3"), ["create_objects", "'type' must be", "3", "create_box"]),
    ("cells that do not fit the box", with_word("fluid", "32 32", "32 40"), ["fluid/ib", "square", "32", "40"]),
    ("side that is no wall", with_word("boundary", "f f p", "p f p"), ["fluid/ib", "wall", "boundary x is 'p'", "boundary f f p"]),
    ("side that moves", with_word("boundary", "f f p", "f m p"), ["fluid/ib", "fixed rectangle", "changes", "use"]),
    ("three dimensions", {"dimension": "dimension 3"}, ["create_objects", "dimension", "3"]),
    ("a wall that leaves its plane", with_word("fluid", "0.1 0", "0.1 0.2"), ["fix water fluid/ib", "within its plane", "0.2", "set it to 0"]),
    ("side that is not there", with_word("fluid", "yhi", "ztop"), ["fix water fluid/ib", "'wall' must be", "'ztop'", "yhi"]),
    ("wrong atom style", {"atoms": "atom_style granular", "neighbor": "neighbor 0.01 bin"}, ["create_objects", "atom_style hybrid granular molecular"]),
    ("largest size below the present one", with_word("swell", "max 0.25", "max 0.1"), ["swell", "'max' must be at least", "0.2", "0.1", "raise"]),
    ("variable that is not there", {"swell": "fix grow all swell diameter v_size"}, ["swell", "'size'", "not defined", "add"]),
    ("no objects for the springs", {"objects": ""}, ["mass_spring", "create_objects"]),
    ("no objects for the swelling", {"objects": "", "springs": ""}, ["swell", "create_objects"]),
    ("fields without a fluid", {"fluid": "", "thermo": ""}, ["output/vtk", "there is no fix fluid/ib", "add one"]),
    ("field that is not there", with_word("output", "pressure", "presure"), ["output/vtk", "'presure'", "pressure"]),
    ("no integrator", {"move": ""}, ["fluid/ib", "integrator", "nve/cds"]),
    ("two integrators for the same points", with_word("move", "nve/cds", "nve/cds\nfix again all nve/cds"),
     ["Fix nve/cds (id move)", "one integrator", "fix again (nve/cds)", "unfix"]),
    ("an integrator of LIGGGHTS beside ours", with_word("move", "nve/cds", "nve/cds\nfix again all nve/sphere"),
     ["Fix nve/cds (id move)", "one integrator", "fix again (nve/sphere)", "unfix"]),
    ("object wider than half a periodic box", dry(boundary="boundary p p p", run="displace_atoms all ramp x 0 2 x 0 1 units box\nrun 10"),
     ["objects", "half a periodic box", "object (molecule) 1", "0.6 wide in x", "in a box of 1", "larger"]),
    ("objects before the box", moved("objects", "map"), ["create_objects", "box"]),
    ("springs before the objects", moved("springs", "pair"), ["mass_spring", "create_objects"]),
    ("fix before the box", moved("fluid", "map"), ["box"]),
    ("file that is not there", {"objects": "create_objects file nowhere.csv"}, ["create_objects", "'nowhere.csv'", "correct"]),
    ("second fluid", with_word("output", "fix out", LINES["fluid"].replace("water", "oil") + "\nfix out"),
     ["fluid/ib", "oil", "one fluid", "water", "unfix"]),
    ("second output into one folder", with_word("output", "fix out", LINES["output"].replace("out all", "twin all") + "\nfix out"),
     ["output/vtk", "out", "folder of its own", "twin", "'post'", "name another"]),
]

RUNAWAY = ["objects", "must", "object (molecule) ", "at step ", "use a shorter time step or softer springs"]

DURING_A_RUN = [
    ("an object leaves the box at once", dry(run="group one molecule 1\nvelocity one set 2000 0 0 units box\nrun 10"),
     ["objects", "keep all its points", "object (molecule) 1 has lost all", "at step 1:", "walls"]),
    ("two objects leave the box at once", dry(run="group two molecule 1 4\nvelocity two set 2000 0 0 units box\nrun 10"),
     ["objects", "keep all its points", "2 objects have lost all", "at step 1:", "walls"]),
    ("an object leaves the box point by point", dry(run="velocity all set 100 0 0 units box\nrun 10"),
     ["objects", "keep all its points", "object (molecule) ", "lost one at step ", "walls"]),
    ("springs too stiff for the time step", dry(springs="fix springs all mass_spring stiffness 1e20", run="run 100"), RUNAWAY),
    ("springs too stiff in a periodic box",
     dry(boundary="boundary p p p", springs="fix springs all mass_spring stiffness 1e20", run="run 100"), RUNAWAY),
    ("springs too stiff between sides that follow",
     dry(boundary="boundary s s p", springs="fix springs all mass_spring stiffness 1e20", run="run 100"), RUNAWAY),
    ("springs somewhat too stiff", dry(springs="fix springs all mass_spring stiffness 1e9", run="run 1000"), RUNAWAY[:-1]),
    ("a force that is not a number, and no reneighbouring",
     dry(run="variable nan equal 1e308*10-1e308*10\ngroup one id 5\nfix push one addforce v_nan 0 0\nrun 10"), RUNAWAY + ["finite"]),
    ("points that become infinite", dry(run="group one id 5\nfix push one addforce 1e308 0 0\ntimestep 1e10\nrun 10"),
     RUNAWAY + ["finite"]),
    ("no set-up after an unfix", {"thermo": "", "run": "run 2\nunfix water\nrun 2 pre no"},
     ["objects", "fixes must stay", "before step 3", "leave out 'pre no'"]),
    ("no set-up after an unfix, integrator last", moved("move", "output").replace(" f_water[1]", "").replace("run 10", "run 2\nunfix water\nrun 2 pre no"),
     ["objects", "fixes must stay", "before step 3", "leave out 'pre no'"]),
]

# Objects may be taken out and made between runs, and whatever number they have.
STAYS_ALLOWED = [
    ("delete between runs", dry(run="run 2\ngroup one molecule 1\ndelete_atoms group one compress no\nrun 10")),
    ("make between runs", dry(run="run 2\ncreate_objects disk 0.5 0.5 diameter 0.05 density 1500\nrun 10")),
    ("large ids", dry(run="group one molecule 1\nset group one mol 2000000000\nrun 10")),
    ("unfix with set-up", {"thermo": "", "output": "", "run": "run 2\nunfix water\nrun 2\nrun 2 pre no"}),
]


class BadInput(ProgramTest):
    timeout = 30

    def check(self, ranks, rows=None, runs=False):
        for name, change, words in rows or ROWS:
            with self.subTest(name, ranks=ranks):
                script = change if isinstance(change, str) else scene(**change)
                result = self.run_program(script, ranks=ranks, name=f"{name} {ranks}".replace(" ", "_"))
                self.assertNotEqual(result.status, 0, "the run went on")
                self.assertNotRegex(result.output, "Segmentation|signal|terminate called|assert", "it crashed")
                self.assertEqual(bool(re.search(r"^ *Step ", result.output, re.M)), runs, "whether the run began")
                messages = [line for line in result.output.splitlines() if line.startswith("ERROR")]
                self.assertEqual(len(messages), 1, result.output[-1500:])
                self.assertNotIn("(/", messages[0], "where in the source, but not where that was built")
                for word in words:
                    self.assertIn(word, messages[0])

    def test_scene_itself_runs(self):
        for ranks in (1, 2):
            result = self.succeed(scene(), ranks=ranks)
            self.assertEqual(result.thermo()[-1]["Step"], 10)

    def test_each_row_on_1_rank(self):
        self.check(1)

    def test_each_row_on_2_ranks(self):
        self.check(2)

    def test_each_row_during_a_run_on_1_rank(self):
        self.check(1, DURING_A_RUN, runs=True)

    def test_each_row_during_a_run_on_2_ranks(self):
        self.check(2, DURING_A_RUN, runs=True)

    def test_what_stays_allowed(self):
        for name, change in STAYS_ALLOWED:
            for ranks in (1, 2):
                with self.subTest(name, ranks=ranks):
                    self.succeed(scene(**change), ranks=ranks, name=f"{name} {ranks}".replace(" ", "_"))


if __name__ == "__main__":
    unittest.main()
