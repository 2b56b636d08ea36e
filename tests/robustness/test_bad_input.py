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

def fluid(words, boundary="f f p", before="", without_lid=True):
    """The scene with words at the end of the fluid's line, which has no moving lid unless it is asked for."""
    line = LINES["fluid"].replace(" wall yhi velocity 0.1 0", "") if without_lid else LINES["fluid"]
    return {"boundary": "boundary " + boundary, "fluid": before + line + " " + words}


PLACE = "fix water fluid/ib"

FLUID_ROWS = [
    ("a side described twice", fluid("slip yhi", without_lid=False), [PLACE, "described once", "yhi is here twice", "take one"]),
    ("a keyword on a periodic side", fluid("slip xlo", "p f p"), [PLACE, "a periodic direction has no sides", "'slip xlo'", "boundary x is 'p'", "leave"]),
    ("sides of which one is periodic", {"boundary": "boundary pf f p"}, ["periodic"]),
    ("inflow and no outflow", fluid("inflow xlo uniform 0.1 0"), [PLACE, "what flows in must leave", "'inflow'", "add 'outflow SIDE'"]),
    ("outflow and no inflow", fluid("outflow xlo"), [PLACE, "leaves what has come in", "'outflow'", "no 'inflow'", "add"]),
    ("inflow that points out", fluid("inflow xlo parabolic -0.1 0 outflow xhi"), [PLACE, "points into the box", "xlo", "-0.1", "change its sign"]),
    ("inflow without its profile", fluid("inflow xlo 0.1 0 outflow xhi"), [PLACE, "'inflow' must be uniform or parabolic", "'0.1'", "change"]),
    ("pressure drop between walls", fluid("pressure_drop 1 0"), [PLACE, "periodic direction", "boundary x is not 'p'", "set it to 0"]),
    ("mean velocity between walls", fluid("mean_velocity y 0.1", "p f p"), [PLACE, "periodic direction", "boundary y is not 'p'", "'inflow'"]),
    ("mean velocity given twice", fluid("mean_velocity x 1 mean_velocity x 1", "p f p"), [PLACE, "once a direction", "'mean_velocity x'", "take one"]),
    ("mean velocity beside a body force", fluid("mean_velocity x 1 body_force 1 0", "p f p"), [PLACE, "'mean_velocity x'", "'body_force'", "set it to 0"]),
    ("mean velocity beside a pressure drop", fluid("mean_velocity x 1 pressure_drop 1 0", "p f p"), [PLACE, "'mean_velocity x'", "'pressure_drop'", "set it to 0"]),
    ("cfl without every", with_word("fluid", "every 2", "cfl 0.5"), [PLACE, "'cfl'", "'every' is missing", "add 'every N'"]),
    ("implicit forcing of free objects", fluid("forcing implicit"), ["fluid/ib", "implicit forcing", "nve/cds", "use 'forcing multi 3'"]),
    ("no time step", {"timestep": "timestep 0"}, ["fluid/ib", "time step", "> 0", "is 0", "timestep"]),
    ("kernel that is not there", fluid("kernel roma"), [PLACE, "'kernel' must be roma_1999", "'roma'", "change"]),
    ("forcing that is not there", fluid("forcing double"), [PLACE, "'forcing' must be direct", "'double'", "change"]),
    ("advection that is not there", fluid("advection upwind"), [PLACE, "'advection' must be central", "'upwind'", "change"]),
    ("driving variable that is not there", fluid("body_force v_g 0"), [PLACE, "'body_force, x'", "equal-style variable", "'g' is not defined", "add"]),
    ("driving variable of another style", fluid("body_force 0 v_g", before="variable g atom x\n"),
     [PLACE, "'body_force, y'", "equal-style variable", "'g' is of another style", "add"]),
    ("start by a variable that is not there", fluid("initial_velocity v_u 0"), [PLACE, "'initial_velocity, x'", "'u' is not defined", "add"]),
]

HOLD = "fix flat all enforce2d\nfix hold all "

HELD_ROWS = [
    ("a keyword of held", {"swell": "", "thermo": "", "move": HOLD + "held velocity 1 0"}, ["fix hold held", "unknown keyword", "'velocity'", "remove"]),
    ("unknown keyword of prescribed", {"swell": "", "thermo": "", "move": HOLD + "prescribed speed 1 0"},
     ["fix hold prescribed", "unknown keyword", "'speed'", "velocity, spin"]),
    ("prescribed by a variable that is not there", {"swell": "", "thermo": "", "move": HOLD + "prescribed spin v_w"},
     ["fix hold prescribed", "'spin'", "equal-style variable", "'w' is not defined", "add"]),
    ("held and free", {"swell": "", "thermo": "", "move": HOLD + "held\nfix move all nve/cds"}, ["(id hold)", "one integrator", "fix move (nve/cds)", "unfix"]),
    ("free and prescribed", {"swell": "", "thermo": "", "move": LINES["move"] + "\nfix hold all prescribed"},
     ["(id move)", "one integrator", "fix hold (prescribed)", "unfix"]),
    ("held and moved by LIGGGHTS", {"swell": "", "thermo": "", "move": HOLD + "held\nfix again all nve/sphere"},
     ["(id hold)", "one integrator", "fix again (nve/sphere)", "unfix"]),
    ("held and growing", {"thermo": "", "move": HOLD + "held"}, ["(id hold)", "keeps its size", "fix grow (swell)", "groups"]),
    ("part of an object held", {"swell": "", "thermo": "", "move": "group some id 1:5\ngroup rest subtract all some\nfix hold some held\nfix move rest nve/cds\nfix flat all enforce2d"},
     ["(id hold)", "all points of an object or none", "object (molecule) 1", "molecule ids"]),
    ("held without objects", {"objects": "", "springs": "", "swell": "", "thermo": "", "move": "fix hold all held"}, ["held", "create_objects"]),
]

ROWS += FLUID_ROWS + HELD_ROWS

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
    ("a wall that begins to leave its plane", fluid("wall yhi velocity 0 v_u", before="variable u equal 0.1*(step>5)\n"),
     ["fix water fluid/ib", "within its plane", "yhi is 0.1", "set it to 0", "variable 'u' for step 6"]),
    ("an inflow that turns round", fluid("inflow xlo uniform v_u 0 outflow xhi", before="variable u equal 5-step\n"),
     ["fix water fluid/ib", "points into the box", "xlo", "is -1", "variable 'u' for step 6"]),
    ("a driving force that is not a number", fluid("body_force v_g 0", before="variable g equal (step>5)*1e308*10\n"),
     ["fix water fluid/ib", "'body_force, x'", "finite number", "variable 'g' gave", "for step 6", "change its formula"]),
    ("a prescribed velocity that is not a number",
     {"swell": "", "thermo": "thermo 5", "move": HOLD + "prescribed velocity v_u 0", "map": LINES["map"] + "\nvariable u equal (step>5)*1e308*10"},
     ["fix hold prescribed", "'velocity, x'", "finite number", "variable 'u' gave", "for step 6", "change its formula"]),
    ("a flow that blows up", {"swell": "", "thermo": "thermo 5", "move": HOLD + "held", "run": "run 200",
                              "fluid": LINES["fluid"].replace("0.1 0", "1000 0")},
     ["the fluid's velocity must stay finite", "step of length 0.002", "use a smaller 'timestep'", "advection bounded"]),
    ("a box that changes under its fluid", {"run": "run 10\nchange_box all x final 0 2 boundary f f p units box\nrun 10"},
     ["fluid/ib", "the box that its line was read with", "to 1 and now", "to 2", "change_box"]),
    ("a time step that changes within a fluid step", {"run": "run 3\ntimestep 5e-4\nrun 3 pre no"},
     ["fluid/ib", "between fluid steps only", "0.001 to 0.0005", "after 1 of 2", "multiple of 'every'"]),
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
    ("periodic sides", fluid("mean_velocity x 0.1", "p f p")),
    ("ordinary atoms and no objects", {"objects": "create_atoms 1 single 0.5 0.5 0\nset group all diameter 0.05 density 1500", "springs": "", "swell": "",
                                       "move": "fix move all nve/sphere\nfix flat all enforce2d", "output": "", "thermo": "thermo 5"}),
    ("multi-direct forcing", fluid("forcing multi 3")),
    ("all sides periodic", fluid("body_force 0 0.1", "p p p")),
    ("held in a stream", {"swell": "", "thermo": "thermo 5", "move": HOLD + "held",
                          "fluid": LINES["fluid"].replace("wall yhi velocity 0.1 0", "inflow xlo parabolic 0.1 0 outflow xhi slip yhi")}),
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

    def test_a_flow_that_nothing_resists_is_warned_of(self):
        alone = {"objects": "", "springs": "", "swell": "", "move": "", "output": "", "contact": "", "pair": "", "thermo": ""}
        alone["region"] = LINES["region"].replace("-0.005 0.005", "-0.02 0.02")
        for boundary, words, expected in (("p p p", "body_force 0 1", 1), ("p f p", "pressure_drop 1 0 slip ylo slip yhi", 1), ("p f p", "pressure_drop 1 0", 0)):
            with self.subTest(words, boundary=boundary):
                result = self.succeed(scene(**{**alone, **fluid(words, boundary)}), ranks=2, name=f"free {boundary} {expected} {len(words)}".replace(" ", "_"))
                self.assertEqual(result.output.count("accelerates without bound"), expected)
        result = self.succeed(scene(**fluid("body_force 0 1", "p p p")), name="objects_resist")
        self.assertNotIn("accelerates", result.output)

    def test_what_stays_allowed(self):
        for name, change in STAYS_ALLOWED:
            for ranks in (1, 2):
                with self.subTest(name, ranks=ranks):
                    self.succeed(scene(**change), ranks=ranks, name=f"{name} {ranks}".replace(" ", "_"))


if __name__ == "__main__":
    unittest.main()
