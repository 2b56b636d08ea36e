"""Bad input ends before any step, on every number of ranks, with one message: rule, value, place and remedy.

A row is a name, the changed line of the scene and what the message must say, in this order: place, rule, value, remedy.
What shows during a run only ends in the same way.
"""

import re
import unittest
from concurrent.futures import ThreadPoolExecutor

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
    ("a number whose square is none", with_word("springs", "1000", "1e200"), ["fix springs mass_spring", "'stiffness' must be a number > 0", "of a magnitude from 1e-100 to 1e100", "'1e200'", "change"]),
    ("a length whose square is nothing", with_word("objects", "diameter 0.2", "diameter 1e-200"), ["create_objects", "'diameter' must be a number > 0", "of a magnitude from", "'1e-200'", "change"]),
    ("NaN", with_word("fluid", "1e-2", "nan"), ["fix water fluid/ib", "'viscosity' must be", "'nan'", "change"]),
    ("negative density", with_word("objects", "1500", "-1500"), ["create_objects", "'density' must be", "'-1500'", "change"]),
    ("negative diameter", with_word("objects", "diameter 0.2", "diameter -0.2"), ["create_objects", "'diameter' must be", "'-0.2'", "change"]),
    ("negative density of the fluid", with_word("fluid", "density 1000", "density -1"),
     ["fix water fluid/ib", "'density' must be", "'-1'", "change"]),
    ("zero steps", with_word("fluid", "every 2", "every 0"), ["fix water fluid/ib", "'every' must be", "'0'", "change"]),
    ("restitution above 1", with_word("springs", "1.0", "1.5"), ["fix springs mass_spring", "'restitution' must be", "'1.5'", "change"]),
    ("springs without a stiffness", {"springs": "fix springs all mass_spring restitution 0.9"},
     ["fix springs mass_spring", "one of the keywords 'stiffness' and 'modulus'", "neither", "add one"]),
    ("springs with two stiffnesses", with_word("springs", "restitution 1.0", "modulus 2"),
     ["fix springs mass_spring", "one of the keywords 'stiffness' and 'modulus'", "both", "leave one out"]),
    ("a table of stiffness that is not there", with_word("springs", "restitution 1.0", "stiffening table soft.csv"),
     ["fix springs mass_spring", "the file must be readable", "'soft.csv'", "correct the name"]),
    ("springs too stiff for the time step", with_word("springs", "1000", "1e9"),
     ["guard", "longest with which springs are stable must be at most 1", "object (molecule) ", "fix springs at step 0", "nve/cds implicit", "guard warn"]),
    ("implicit motion without springs", {"springs": "", "move": "fix move all nve/cds implicit"},
     ["nve/cds (id move)", "must have one fix mass_spring", "has none", "add one"]),
    ("implicit motion with springs twice", {"springs": LINES["springs"] + "\nfix more all mass_spring stiffness 1", "move": "fix move all nve/cds implicit"},
     ["nve/cds (id move)", "must have one fix mass_spring", "has several", "unfix"]),
    ("an energy that is not offered", {"move": "fix move all nve/cds implicit energy waste"},
     ["fix move nve/cds implicit", "'energy' must be", "'waste'", "dissipate"]),
    ("a word that is not an integrator's", {"move": "fix move all nve/cds explicit"}, ["fix move nve/cds", "unknown keyword", "'explicit'", "remove"]),
    ("a lubrication that never grows", {"move": LINES["move"] + "\nfix gaps all lubrication/cds viscosity 10 cutoff 0.04 minimum 0.05"},
     ["fix gaps lubrication/cds", "'minimum' must be less than 'cutoff' and 'pair_cutoff' (0.028)", "'0.05'", "change"]),
    ("lubrication between what is no disc", {"objects": "create_objects ellipse 0.5 0.5 axes 0.3 0.2 points 32 density 1500 cds 0.2",
                                             "move": LINES["move"] + "\nfix gaps all lubrication/cds viscosity 10 cutoff 0.04 minimum 0.001"},
     ["lubrication/cds", "between discs", "object (molecule) 1", "another shape", "use a group of discs"]),
    ("a free atom among rigid objects", {"move": "create_atoms 1 single 0.1 0.1 0 units box\nset group all density 1000 diameter 0.01\nfix stiff all rigid/cds"},
     ["rigid/cds", "stiff", "moves points of objects", "1 atoms", "none", "nve/sphere"]),
    ("rigid and free", {"move": "fix move all nve/cds\nfix stiff all rigid/cds"}, ["(id move)", "one integrator", "fix stiff (rigid/cds)", "unfix"]),
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

GUARD_ROWS = [
    ("contacts too stiff for the time step", with_word("contact", "kn peratomtypepair 1 1e4", "kn peratomtypepair 1 1e9"),
     ["guard", "longest with which contacts are stable must be at most 2", "type 1 with those of type 1 at step 0", "make contacts softer", "guard warn"]),
    ("Young's modulus too large for the time step",
     {"contact": "fix Y all property/global youngsModulus peratomtype 1e9\nfix nu all property/global poissonsRatio peratomtype 0.3\n"
                 "fix e all property/global coefficientRestitution peratomtypepair 1 0.9\nfix mu all property/global coefficientFriction peratomtypepair 1 0.3",
      "pair": "pair_style gran model hertz tangential history\npair_coeff * *", "timestep": "timestep 1e-2"},
     ["guard", "longest with which contacts are stable must be at most 2", "make contacts softer", "guard warn"]),
    ("rigid objects with too stiff contacts", {**with_word("contact", "kn peratomtypepair 1 1e4", "kn peratomtypepair 1 1e10"), "move": "fix move all rigid/cds"},
     ["guard", "longest with which contacts are stable must be at most 2", "guard warn"]),
    ("a side that moves by many cells in a step", with_word("fluid", "velocity 0.1 0", "velocity 1e4 0"),
     ["guard", "CFL number must be at most 10", "is 640 for a side of the box, fix water at step 0", "'timestep'", "'cfl 0.5'", "guard warn"]),
    ("a flow that starts too fast", with_word("fluid", "velocity 0.1 0", "velocity 0.1 0 initial_velocity 9e3 0"), ["guard", "CFL number", "the flow as it is, fix water", "'timestep'"]),
    ("an object smaller than a cell", with_word("fluid", "cells 32 32", "cells 4 4"),
     ["guard", "cell over the diameter of an object must be at most 1, but is 1.25 for object (molecule) 1", "use more 'cells'", "guard warn"]),
    ("an object that grows past what it touches", dry(swell="fix grow all swell linear rate 1e3 max 0.6"),
     ["guard", "growth of an outline in a time step over the radius of its spheres must be at most 1", "fix grow", "swell slower", "guard warn"]),
    ("an object that grows before its springs can follow", with_word("swell", "6e-4 max 0.25", "20 max 0.5"),
     ["guard", "while springs pull an outline after it, must be at most 0.5", "object (molecule) ", "fix grow", "stiffer springs", "guard warn"]),
    ("a rigid object that is to be wider than the box", dry(move="fix move all rigid/cds\nfix flat all enforce2d", swell="fix grow all swell linear rate 9 max 1.1", run="run 110"),
     ["guard", "diameter of a rigid object at the end of the run over the width of the box must be at most 1, but is 1.1", "object (molecule) ", "fix grow", "guard warn"]),
    ("a fluid too viscous for the step of free objects", with_word("fluid", "viscosity 1e-2", "viscosity 100"),
     ["guard", "over the square of a cell, with objects that move, must be at most 100, but is 204.8 for fix water at step 0", "a smaller 'every'", "guard warn"]),
    ("an object that is to be larger than the box", with_word("swell", "6e-4 max 0.25", "1e3 max 5"), ["guard", "fix grow", "guard warn"]),
    ("a guard that is not there", {"timestep": "timestep 1e-3\nguard weak"}, ["guard", "'mode' must be refuse or warn or off", "'weak'", "change"]),
    ("a guard without a word", {"timestep": "timestep 1e-3\nguard"}, ["guard", "not enough arguments", "'mode'", "give"]),
    ("a guard with too many words", {"timestep": "timestep 1e-3\nguard off on"}, ["guard", "unknown keyword", "'on'", "remove"]),
    ("the hidden guard", {"timestep": "timestep 1e-3\nfix safe all guard"}, ["fix", "guard", "made with the box", "use the command 'guard'"]),
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
    ("outflow and no inflow", fluid("outflow xlo"), [PLACE, "leaves what has come in", "'outflow'", "no 'inflow'", "no fix swell", "add"]),
    ("objects that push water away in a closed box", {"swell": LINES["swell"] + " absorb no"},
     [PLACE, "must be able to leave", "fix grow has 'absorb no'", "no 'outflow'", "add 'outflow SIDE'", "'absorb yes'"]),
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
    ("linear start without walls", fluid("initial_velocity linear", "p p p"),
     [PLACE, "two walls that face each other", "there are none", "give the initial velocity as VX VY"]),
    ("linear start between walls that both ways move", fluid("initial_velocity linear wall xlo velocity 0 1", without_lid=False),
     [PLACE, "two walls that face each other", "walls move in x and in y", "change the sides"]),
    ("linear start from a wall to no wall", fluid("initial_velocity linear slip ylo", without_lid=False),
     [PLACE, "two walls that face each other", "yhi moves and ylo is no wall", "change the sides"]),
    ("start that is not there", fluid("initial_velocity linaer"), [PLACE, "'initial_velocity' must be 'linear'", "'linaer'", "change"]),
    ("start by a variable that is not there", fluid("initial_velocity v_u 0"), [PLACE, "'initial_velocity, x'", "'u' is not defined", "add"]),
]

BALANCED = LINES["pair"] + "\naccuracy balanced"
AUTO = with_word("fluid", "cells 32 32", "cells auto")

ACCURACY_ROWS = [
    ("an accuracy that is not there", {"pair": LINES["pair"] + "\naccuracy quick"}, ["accuracy", "must be fast or balanced or accurate or report", "'quick'", "change"]),
    ("an accuracy without a word", {"pair": LINES["pair"] + "\naccuracy"}, ["accuracy", "not enough arguments", "fast or balanced", "give"]),
    ("an accuracy with too many words", {"pair": BALANCED + " fast"}, ["accuracy", "unknown keyword", "'fast'", "remove"]),
    ("an accuracy behind the objects", {"objects": LINES["objects"] + "\naccuracy fast"}, ["accuracy", "there are objects already", "put it above 'create_objects'"]),
    ("an accuracy behind the fluid", {**dry(), "objects": "fix water all fluid/ib cells 32 32 density 1 viscosity 1\naccuracy fast"}, ["accuracy", "there is a fluid already", "put it above"]),
    ("cells by an accuracy that was not given", AUTO, ["fix water fluid/ib", "'cells auto'", "'accuracy', which was not given", "add 'accuracy balanced'", "'cells NX NY'"]),
    ("cells by objects that are not there", {"pair": BALANCED + "\nfix water all fluid/ib cells auto density 1 viscosity 1"},
     ["fix water fluid/ib", "'cells auto' goes by the smallest object", "there is none", "below 'create_objects'"]),
    ("cells that cannot be square", {**AUTO, "pair": BALANCED, "region": LINES["region"].replace("0 1 0 1", "0 1 0 0.9777")},
     ["fix water fluid/ib", "cells must be square", "a box of 1 x 0.9777", "make it 1 x 0.983333", "60 x 59 cells", "'cells NX NY'"]),
    ("too many cells", {**AUTO, "pair": BALANCED, "objects": LINES["objects"].replace("diameter 0.2", "diameter 2e-4")},
     ["fix water fluid/ib", "4 to 46340 cells along a side", "'cells NX NY'"]),
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

ROWS += GUARD_ROWS + ACCURACY_ROWS + FLUID_ROWS + HELD_ROWS


SCALAR = "fix fresh fluid/scalar"


def carried(words, line=LINES["fluid"], **changes):
    """The scene with a scalar below its fluid."""
    return {"fluid": line + "\nfix fresh all fluid/scalar " + words, **changes}


ROWS += [
    ("a scalar without a fluid", {"fluid": "fix fresh all fluid/scalar diffusivity 0", "thermo": "", "output": ""},
     ["fluid/scalar", "fresh", "no fix fluid/ib", "add one above"]),
    ("a scalar above its fluid", {"fluid": "fix fresh all fluid/scalar diffusivity 0\n" + LINES["fluid"]}, ["fluid/scalar", "fresh", "below fix fluid/ib"]),
    ("a scalar that would overflow", carried("diffusivity 0 initial 1e308"), [SCALAR, "'initial' must be", "of a magnitude", "'1e308'", "change"]),
    ("a scalar without diffusivity", carried("initial 1"), [SCALAR, "'diffusivity'", "length^2/time"]),
    ("a feed at a wall", carried("diffusivity 0 feed ylo 1"), [SCALAR, "'feed'", "nothing flows through ylo", "use 'value ylo C'"]),
    ("a value at a periodic side", carried("diffusivity 0 value xlo 1", boundary="boundary p f p"), [SCALAR, "xlo is periodic", "use 'feed xlo C'"]),
    ("an inflow of nobody knows what", carried("diffusivity 0", LINES["fluid"] + " inflow xlo uniform 0.1 0 outflow xhi"),
     [SCALAR, "what an inflow brings", "nothing is said of xlo", "add 'feed xlo C'"]),
    ("a side of a scalar twice", carried("diffusivity 0 value ylo 1 value ylo 2"), [SCALAR, "described once", "ylo is here twice", "take one"]),
    ("a scalar in a region that is not there", carried("diffusivity 0 region left 1"), [SCALAR, "'region' must name a region", "'left'", "define it above"]),
    ("a scalar with a name of the fluid's", {"fluid": LINES["fluid"] + "\nfix pressure all fluid/scalar diffusivity 0"},
     ["fix pressure fluid/scalar", "names the scalar's field", "use another id"]),
    ("food that is not there", with_word("swell", "max 0.25", "max 0.25 fed_by fresh"), ["swell", "grow", "'fed_by' must name a fix fluid/scalar", "'fresh' is no fix", "add one"]),
    ("food that is none", with_word("swell", "max 0.25", "max 0.25 fed_by water"), ["swell", "'fed_by' must name a fix fluid/scalar", "'water' is a fix of another style"]),
    ("full of nothing", with_word("swell", "max 0.25", "max 0.25 full 2"), ["fix grow swell", "'full' needs 'fed_by'", "add it"]),
    ("food for a variable", {"swell": "variable d equal 0.2\nfix grow all swell diameter v_d fed_by fresh"},
     ["fix grow swell", "'fed_by' needs a clock for each object", "remove 'fed_by'"]),
]

MEASURES = LINES["output"] + "\nfix sums all output/objects "
IN = "fix sums output/objects"

MEASURE_ROWS = [
    ("measures without an interval", {"output": MEASURES + "file a.csv"}, [IN, "'every' is missing", "add"]),
    ("measures every 0 steps", {"output": MEASURES + "every 0 file a.csv"}, [IN, "'every' must be", "'0'", "change"]),
    ("unknown keyword of the measures", {"output": MEASURES + "every 10 files a.csv"}, [IN, "unknown keyword", "'files'", "every, file, objects"]),
    ("an object id that is none", {"output": MEASURES + "every 10 objects 0"}, [IN, "'objects' must be", "'0'", "change"]),
    ("a word in place of object ids", {"output": MEASURES + "every 10 objects some"}, [IN, "'objects' must be all", "'some'", "change"]),
    ("an object that is not in the group", {"output": "group two molecule 1 2\n" + MEASURES.replace("sums all", "sums two") + "every 10 objects 2 3"},
     ["output/objects", "sums", "must name objects of the group", "'two' has no object (molecule) 3", "change"]),
    ("measures into what is no folder", {"output": MEASURES + "every 10 file /dev/null/a.csv"},
     ["output/objects", "cannot write '/dev/null/a.csv'", "name another file"]),
    ("measures into a device", {"output": MEASURES + "every 10 file /dev/null"}, ["output/objects", "cannot write '/dev/null'", "name another file"]),
    ("measures into a file of something else", {"output": "print 'my thesis' file a.csv\n" + MEASURES + "every 10 file a.csv"},
     ["output/objects", "'a.csv' must hold measures of objects", "begins with 'my thesis'", "name another file"]),
    ("two measures into one file", {"output": MEASURES + "every 10 file a.csv\n" + MEASURES.splitlines()[-1].replace("sums", "more") + "every 5 file a.csv"},
     ["output/objects", "more", "a file of its own", "fix sums", "'a.csv'", "name another"]),
    ("measures before there are objects", {"objects": "", "springs": "", "swell": "", "output": "fix sums all output/objects every 10", "thermo": ""},
     ["output/objects", "create_objects"]),
    ("measures before weight is added", {"output": MEASURES + "every 10 file a.csv\nfix late all gravity 9.81 vector 0 -1 0"},
     ["output/objects", "sums", "when all forces have been summed up", "fix late (gravity)", "put it above"]),
    ("centres before weight is added", {"output": LINES["output"] + " centres\nfix late all gravity 9.81 vector 0 -1 0"},
     ["output/vtk", "when all forces have been summed up", "fix late (gravity)", "put it above"]),
    ("part of an object measured", {"output": "group some id 1:5\nfix sums some output/objects every 10"},
     ["output/objects", "all points of an object or none", "object (molecule) 1", "molecule ids"]),
]

ROWS += MEASURE_ROWS

GROW = "fix grow swell"


def swell(law, **changes):
    return {"swell": "fix grow all swell " + law, **changes}


def table(*lines):
    """A scene that grows by a table with these lines."""
    first, *others = lines
    text = [f"print '{first}' file law.csv screen no"] + [f"print '{line}' append law.csv screen no" for line in others]
    return {"swell": "\n".join(text) + "\nfix grow all swell table law.csv"}


SWELL_ROWS = [
    ("a law that is not there", swell("quadratic 1"), [GROW, "'law' must be linear or", "'quadratic'", "change"]),
    ("a clock that stands still", swell("linear rate 1e-3 max 0.25 clock 0"), [GROW, "'clock' must be a number > 0", "'0'", "change"]),
    ("a clock for a variable", swell("diameter v_d clock 10"), [GROW, "'clock' needs a law with a time of its own", "variable 'd' gives one size", "remove 'clock'"]),
    ("a rate without its end", swell("linear rate 1e-3 min 0.1"), [GROW, "a rate >= 0 ends at 'max'", "missing", "add"]),
    ("shrinking without its end", swell("linear rate -1e-3"), [GROW, "a rate < 0 ends at 'min'", "missing", "add"]),
    ("shrinking with two ends", swell("linear rate -1e-3 min 0.1 max 0.3"), [GROW, "a rate < 0 ends at 'min'", "'max' is given", "remove"]),
    ("smallest size above the present one", swell("linear rate -1e-3 min 0.3"), ["swell", "'min' must be at most", "0.2", "0.3", "lower"]),
    ("a polynomial without coefficients", swell("polynomial until 5"), [GROW, "'polynomial' must be a number", "'until'", "change"]),
    ("a polynomial without its end", swell("polynomial 0.2 1e-3"), [GROW, "'until' is missing", "add"]),
    ("a polynomial of something else", swell("polynomial 1 1e-3 until 5 gives radius"), [GROW, "'gives' must be diameter or ratio", "'radius'", "change"]),
    ("a polynomial that ends below zero", swell("polynomial 0.2 -30 until 10"),
     ["swell", "grow", "natural diameter must be > 0", "object (molecule) 1", "-0.1 at time 0.01", "let it end earlier"]),
    ("a polynomial that dips below zero", swell("polynomial 1 -500 62000 until 10 gives ratio", run="run 100"),
     ["swell", "grow", "natural diameter must be > 0", "object (molecule) 1 the diameter -0.001613 at time 0.004032", "change the law"]),
    ("a polynomial that overflows", swell("polynomial 0.2 1e100 1e100 1e100 1e100 until 1e90", timestep="timestep 1e60"),
     ["swell", "grow", "natural diameter must be", "object (molecule) 1", "infinity at time 1e+61", "change the law"]),
    ("a hydrogel that is not there", swell("hydrogel measured"), [GROW, "'hydrogel' must be printed or reconstructed", "'measured'", "change"]),
    ("a hydrogel in units without a millimetre", swell("hydrogel printed", units="units lj"), [GROW, "'millimetre' is missing", "add"]),
    ("a law's file that is not there", swell("table nowhere.csv"), [GROW, "file must be readable", "'nowhere.csv'", "correct"]),
    ("a law's table of something else", table("time,size", "0,1", "1,2"), [GROW, "law.csv line 1", "'size'", "time, diameter, ratio"]),
    ("a law's table without times", table("diameter", "0.2", "0.3"), [GROW, "law.csv", "must be time and either diameter or ratio", "correct"]),
    ("a law's table of two sizes", table("time,diameter,ratio", "0,0.2,1", "1,0.3,2"), [GROW, "time and either diameter or ratio", "correct"]),
    ("a law's table in disorder", table("time,ratio", "0,1", "2,2", "1,3"), [GROW, "law.csv line 4", "must ascend", "1 follows 2", "sort"]),
    ("a law's table down to nothing", table("time,ratio", "0,1", "2,0"), [GROW, "law.csv line 3", "'ratio' must be > 0", "is 0", "change"]),
    ("a law's table of one line", table("time,ratio", "0,1"), [GROW, "law.csv", "two times or more", "add"]),
    ("Tanaka and Fillmore without a speed", swell("tanaka_fillmore final 0.3"), [GROW, "'tau' and 'diffusivity'", "both missing", "add one"]),
    ("Tanaka and Fillmore with two speeds", swell("tanaka_fillmore final 0.3 tau 1 diffusivity 1"), [GROW, "'tau' and 'diffusivity'", "both given", "keep one"]),
    ("a size that is no variable", swell("diameter 0.3"), [GROW, "written v_NAME", "'0.3'", "change"]),
    ("scatter without a seed", swell("linear rate 1e-3 max 0.3 scatter 0.1 0.1"), [GROW, "'scatter' needs 'seed'", "missing", "add"]),
    ("scatter of one", swell("linear rate 1e-3 max 0.3 scatter 0.1 seed 3"), [GROW, "'scatter, size' must be", "'seed'", "change"]),
    ("a scattered speed of a variable", {"map": LINES["map"] + "\nvariable size equal 0.2", **swell("diameter v_size scatter 0.1 0 seed 2")},
     [GROW, "clock for each object", "variable 'size'", "remove"]),
    ("shrinking that scatter takes below zero", swell("linear rate -100 min 0.01 scatter 0 1 seed 1"),
     ["swell", "grow", "natural diameter must be > 0", "object (molecule) ", "-0.", "at time 0.01 ", "change the law"]),
    ("an exponent without load", swell("linear rate 1e-3 max 0.3 exponent 2"), [GROW, "'exponent' needs 'load'", "missing", "add"]),
    ("load on a variable", {"map": LINES["map"] + "\nvariable size equal 0.2", **swell("diameter v_size load 5")},
     [GROW, "clock for each object", "variable 'size'", "remove 'load'"]),
    ("load before there are all forces", swell("linear rate 1e-3 max 0.3 load 5"), ["swell", "grow", "all forces have been summed up", "fix flat", "put it above"]),
    ("drink without its density", swell("linear rate 1e-3 max 0.3 mass drink"), [GROW, "'mass drink' needs 'water_density'", "missing", "add"]),
    ("a water density without drink", swell("linear rate 1e-3 max 0.3 water_density 1"), [GROW, "'water_density' belongs to 'mass drink'", "add"]),
    ("drying to no mass", swell("linear rate -100 min 0.05 mass drink water_density 3000"),
     ["swell", "grow", "large enough for a mass > 0", "object (molecule) 1", "0.05 at time 0.01 ", "change the law"]),
]

ROWS += SWELL_ROWS

ELLIPSE = "create_objects ellipse 0.5 0.5 axes 0.3 0.2 density 1500"


def written(lines, command):
    """A scene whose objects come from a file with these lines."""
    first, *others = lines.split(" / ")
    text = [f"print '{first}' file shape.csv screen no"] + [f"print '{line}' append shape.csv screen no" for line in others]
    return {"objects": "\n".join(text) + "\n" + command}


OUTLINE = "create_objects outline shape.csv 0.5 0.5 diameter 0.3 density 1500"
BAY = "x,y / 0,0 / 4,0 / 4,1 / 1,1 / 1,3 / 4,3 / 4,4 / 0,4"

SHAPE_ROWS = [
    ("a shape that is not there", {"objects": "create_objects square 0.5 0.5"}, ["create_objects", "'form' must be disk or ellipse", "'square'", "change"]),
    ("an ellipse without axes", {"objects": ELLIPSE.replace(" axes 0.3 0.2", "")}, ["create_objects ellipse", "'axes' is missing", "add"]),
    ("an ellipse with one axis", {"objects": ELLIPSE.replace(" 0.2", "")}, ["create_objects ellipse", "'axes' must be a number > 0", "'density'", "change"]),
    ("an ellipse with a diameter", {"objects": ELLIPSE + " diameter 0.2"}, ["create_objects ellipse", "unknown keyword", "'diameter'", "axes"]),
    ("points in another spacing", {"objects": ELLIPSE + " point_spacing even"}, ["create_objects ellipse", "'point_spacing' must be arc or angle", "'even'", "change"]),
    ("an ellipse that sticks out", {"objects": ELLIPSE.replace("0.5 0.5", "0.14 0.5")}, ["create_objects ellipse", "inside the box", "(0.14, 0.5)", "0.3 wide in x", "move"]),
    ("turned ellipses that overlap", {"objects": ELLIPSE + " angle 45\n" + ELLIPSE.replace("0.5 0.5", "0.6 0.6")},
     ["create_objects ellipse", "must not overlap", "(0.6, 0.6) overlaps an earlier one at (0.5, 0.5) by 0.0", "move"]),
    ("spheres that reach too far", with_word("objects", "cds 0.2", "cds 0.1 reach 0.2"), ["create_objects", "'reach' must be at most 'cds'", "0.1, but is 0.2", "lower it"]),
    ("spheres that end inside", with_word("objects", "cds 0.2", "cds 0.1 reach -0.1"), ["create_objects", "'reach' must be a number >= 0", "'-0.1'", "change"]),
    ("a ring too far inside", with_word("objects", "cds 0.2", "cds 0.2 reach 0"), ["create_objects", "moment of inertia of the solid shape", "so far inside", "'mass equal'"]),
    ("points inside without spokes", with_word("objects", "cds 0.2", "cds 0.1 reach 0 spokes no"), ["create_objects", "need spokes", "leave 'reach' out"]),
    ("a free hub with a sphere", with_word("objects", "cds 0.2", "spokes no hub_cds yes"), ["create_objects", "hub without spokes", "'hub_cds yes'", "leave it out"]),
    ("spheres that do not divide the points", with_word("objects", "cds 0.2", "cds_points 5"), ["create_objects", "'cds_points' must divide", "16", "is 5", "change"]),
    ("sizes without a seed", with_word("objects", "cds 0.2", "sizes normal 0.1"), ["create_objects", "here must stand 'seed'", "'type'", "change"]),
    ("sizes that spread too far", with_word("objects", "cds 0.2", "sizes normal 0.4 seed 1"), ["create_objects", "'sizes' must be a number in (0, 0.3]", "'0.4'", "change"]),
    ("sizes of another kind", with_word("objects", "cds 0.2", "sizes gauss 0.1 seed 1"), ["create_objects", "'sizes' must be normal or lognormal or uniform", "'gauss'", "change"]),
    ("an outline that is not there", {"objects": OUTLINE.replace("shape", "nowhere")}, ["create_objects", "'nowhere.csv'", "correct"]),
    ("an outline of two points", written("x,y / 0,0 / 1,0", OUTLINE), ["shape.csv line 3", "at least 3 points", "add"]),
    ("an outline that is closed by hand", written("x,y / 0,0 / 1,0 / 0,1 / 0,0", OUTLINE), ["shape.csv line 5", "each point once", "that of line 2", "leave it out"]),
    ("an outline that crosses itself", written("x,y / 0,0 / 1,1 / 1,0 / 0,1", OUTLINE), ["shape.csv line 4", "must not cross or touch itself", "line 2", "correct"]),
    ("an outline with a column too many", written("x,y,z / 0,0,0", OUTLINE), ["shape.csv line 1", "'z'", "known are x, y"]),
    ("an outline whose hub lies outside", written(BAY, OUTLINE), ["create_objects outline", "spokes must stay inside the outline", "'spokes no'"]),
    ("an outline with rays that leave it twice", written(BAY, OUTLINE + " spokes no point_spacing angle"),
     ["create_objects outline", "equal angles", "leaves it", "'point_spacing arc'"]),
    ("an outline of too few points", written(BAY, OUTLINE + " points 2"), ["create_objects outline", "'points' must be 0", "is 2", "change"]),
    ("a table with a wrong reach", written("x,y,reach / 0.5,0.5,0.3", "create_objects file shape.csv diameter 0.2 density 1500"),
     ["shape.csv line 2", "'reach' must be at most 'cds'", "lower it"]),
    ("a table of ellipses without axes", written("x,y,diameter / 0.5,0.5,0.3", "create_objects file shape.csv ellipse density 1500"),
     ["create_objects file", "'axes' is missing", "add"]),
    ("hubs that follow without velocities", dry(**with_word("objects", "cds 0.2", "spokes no"), ghosts="", contact="", pair=""),
     ["objects", "hub without spokes needs the velocities", "communicate single vel yes"]),
    ("neighbours of points without spheres", {"objects": LINES["objects"].replace("spacing 0.4", "spacing 0.201") + " cds_points 8\nneigh_modify exclude none exclude molecule all"},
     ["objects", "points without a sphere must have no neighbours", "above 'create_objects'"]),
    ("spheres of one object that push each other", with_word("neighbor", "exclude molecule all", "every 1"),
     ["objects", "must not push each other apart", "exclude molecule all"]),
]

ROWS += SHAPE_ROWS

RANDOM = "create_objects random number 5 within box disk diameter 0.1 density 1500 cds 0.1 reach 0 seed 1"
PLACE = "create_objects random"


def at_random(old, new, above=""):
    assert old in RANDOM, old
    return {"objects": above + RANDOM.replace(old, new)}


RANDOM_ROWS = [
    ("at random, but how many", at_random("number 5", "many"), [PLACE, "'how many' must be number or solid_fraction", "'many'", "change"]),
    ("no objects at random", at_random("number 5", "number 0"), [PLACE, "'number' must be a whole number in [1, ", "'0'", "change"]),
    ("all of the place", at_random("number 5", "solid_fraction 1"), [PLACE, "'solid_fraction' must be a number in (0, 1)", "'1'", "change"]),
    ("at random nowhere", at_random("within box ", ""), [PLACE, "here must stand 'within'", "'disk'", "change"]),
    ("at random in a ball", at_random("within box", "within ball"), [PLACE, "'within' must be box or rectangle or region", "'ball'", "change"]),
    ("a rectangle out of the box", at_random("within box", "within rectangle 0 1 0.5 1.5"), [PLACE, "rectangle must lie in the box", "from 0 to 1, but is from 0.5 to 1.5", "change"]),
    ("a rectangle that is turned round", at_random("within box", "within rectangle 0.6 0.2 0 1"), [PLACE, "rectangle must lie in the box", "from 0.6 to 0.2", "change"]),
    ("a region that is not there", at_random("within box", "within region drum"), [PLACE, "'region' must name a region", "'drum'", "correct"]),
    ("a region out of the box", at_random("within box", "within region far", "region far sphere 5 5 0 1 units box\n"), [PLACE, "'far' must reach into the box", "move"]),
    ("at random without a seed", at_random(" seed 1", ""), [PLACE, "'seed' is missing", "add"]),
    ("a gap below zero", at_random("seed 1", "seed 1 gap -1"), [PLACE, "'gap' must be a number >= 0", "'-1'", "change"]),
    ("turned at will", at_random("seed 1", "seed 1 orientation upright"), [PLACE, "'orientation' must be random or aligned", "'upright'", "change"]),
    ("too dense", at_random("number 5", "solid_fraction 0.95"), [PLACE, "must fit into their place", "0.95", "about 0.", "can be reached", "lower 'gap'"]),
    ("too dense with spheres that reach out", {"objects": RANDOM.replace("number 5", "number 80").replace(" reach 0", "")},
     [PLACE, "must fit into their place", "80 objects", "reach 0.1 diameters beyond", "lower 'gap' or 'reach'"]),
    ("less than one object", at_random("number 5", "solid_fraction 1e-3"), [PLACE, "at least one object", "0.001", "raise 'solid_fraction'"]),
    ("a gap in a lattice", with_word("objects", "cds 0.2", "gap 0.1"), ["create_objects lattice", "unknown keyword 'gap'"]),
    ("overlap below zero", written("x,y / 0.5,0.5", "create_objects file shape.csv diameter 0.2 density 1500 overlap -1"), ["create_objects file", "'overlap' must be a number >= 0", "change"]),
    ("more overlap than was said", written("x,y / 0.3,0.5 / 0.45,0.5", "create_objects file shape.csv diameter 0.2 density 1500 overlap 0.01"),
     ["shape.csv line 3", "must not overlap", "by 0.05", "move"]),
]

ROWS += RANDOM_ROWS

# What would end without a word, or never, were it begun.
TOO_MUCH_ROWS = [
    ("more cells than the memory holds", with_word("fluid", "32 32", "1000000 1000000"), ["fix water fluid/ib", "1000000 x 1000000 cells must fit into the memory", "1e+05 GB", "ask for fewer"]),
    ("more objects than anybody counts", with_word("objects", "2 2", "1000000 1000000"), ["create_objects lattice", "at most 1e7 objects", "1000000 x 1000000", "ask for fewer"]),
    ("more points than LIGGGHTS counts", {"objects": LINES["objects"].replace("2 2", "3000 3000").replace("points 16", "points 10000")},
     ["create_objects lattice", "numbers points up to 2147483647", "9.001e+10", "fewer objects"]),
    ("more points than an outline has use for", with_word("objects", "points 16", "points 10001"), ["create_objects", "'points' must be a whole number in [3, 10000]", "'10001'", "change"]),
    ("more at random than the whole place", at_random("number 5", "number 100000"), [PLACE, "must fit into their place", "100000 objects, a solid fraction of 785.4", "ask for less"]),
    ("markers without end", fluid("marker_gap 1e-9"), ["fix water fluid/ib", "'marker_gap' must be a number >= 0.01", "'1e-9'", "change"]),
    ("forcing without end", fluid("forcing multi 1000000"), ["fix water fluid/ib", "'forcing multi' must be a whole number in [1, 1000]", "'1000000'", "change"]),
    ("gaps wider than the box", {"move": LINES["move"] + "\nfix gaps all lubrication/cds viscosity 10 cutoff 1e9 minimum 1e-3"},
     ["fix gaps lubrication/cds", "at most the shorter side of the box, 1,", "are 1e+09 and 7e+08", "lower"]),
]

ROWS += TOO_MUCH_ROWS

RUNAWAY = ["objects", "must", "object (molecule) ", "at step ", "use a shorter time step or softer springs"]

DURING_A_RUN = [
    ("an object leaves the box at once", dry(run="group one molecule 1\nvelocity one set 2000 0 0 units box\nrun 10"),
     ["objects", "keep all its points", "object (molecule) 1 has lost all", "at step 1:", "walls"]),
    ("two objects leave the box at once", dry(run="group two molecule 1 4\nvelocity two set 2000 0 0 units box\nrun 10"),
     ["objects", "keep all its points", "2 objects have lost all", "at step 1:", "walls"]),
    ("an object leaves the box point by point", dry(run="velocity all set 100 0 0 units box\nrun 10"),
     ["objects", "keep all its points", "object (molecule) ", "lost one at step ", "walls"]),
    ("a point that is torn off", dry(run="group one id 5\nfix push one addforce 1e9 0 0\nrun 100"), RUNAWAY),
    ("a point that is torn off in a periodic box", dry(boundary="boundary p p p", run="group one id 5\nfix push one addforce 1e5 0 0\nrun 100"), RUNAWAY),
    ("a point that is torn off between sides that follow", dry(boundary="boundary s s p", run="group one id 5\nfix push one addforce 1e9 0 0\nrun 100"), RUNAWAY),
    ("objects that shrink until the time step is too long",
     dry(map=LINES["map"] + "\nvariable size equal 1-0.18*step/5000", swell="fix grow all swell ratio v_size", timestep="timestep 1e-2", run="run 25000",
         springs="fix springs all mass_spring stiffness 5000"),
     ["guard", "longest with which springs are stable must be at most 1, but is 1.0", "object (molecule) ", "fix springs at step ", "shorten 'timestep' to", "'nve/cds implicit'"]),
    ("a variable size that becomes negative", dry(map=LINES["map"] + "\nvariable size equal 0.2-0.1*step", swell="fix grow all swell diameter v_size"),
     ["swell", "grow", "natural diameter must be > 0", "variable 'size' gives object (molecule) 1", "diameter 0 at time 0.002", "change its formula"]),
    ("a variable size that is not a number", dry(map=LINES["map"] + "\nvariable size equal 0.2+(step>3)*1e308*10", swell="fix grow all swell diameter v_size"),
     [GROW, "'diameter'", "finite number", "variable 'size' gave", "for step 4", "change its formula"]),
    ("a variable size that scatter takes below zero",
     dry(map=LINES["map"] + "\nvariable size equal 0.2-0.02*step", swell="fix grow all swell diameter v_size scatter 0 1 seed 1", run="guard off\nrun 10"),
     ["swell", "grow", "natural diameter must be > 0", "variable 'size' gives object (molecule) ", "at time 0.00", "change its formula"]),
    ("a force that is not a number, and no reneighbouring",
     dry(run="variable nan equal 1e308*10-1e308*10\ngroup one id 5\nfix push one addforce v_nan 0 0\nrun 10"), ["guard", "must be finite", "object (molecule) 1", "at step 5"]),
    ("points that become infinite", dry(springs="", run="guard off\ngroup one id 5\nfix push one addforce 1e308 0 0\ntimestep 1e10\nrun 10"),
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
    ("a flow that blows up", {"swell": "", "thermo": "thermo 5", "move": HOLD + "held", "run": "guard off\nrun 200",
                              "fluid": LINES["fluid"].replace("0.1 0", "1000 0")},
     ["the fluid's velocity must stay finite", "step of length 0.002", "use a smaller 'timestep'", "advection bounded"]),
    ("a box that changes under its fluid", {"run": "run 10\nchange_box all x final 0 2 boundary f f p units box\nrun 10"},
     ["fluid/ib", "the box that its line was read with", "to 1 and now", "to 2", "change_box"]),
    ("a time step that changes within a fluid step", {"run": "run 3\ntimestep 5e-4\nrun 3 pre no"},
     ["fluid/ib", "between fluid steps only", "0.001 to 0.0005", "after 1 of 2", "multiple of 'every'"]),
    ("a folder of measures that vanishes", {"output": LINES["output"] + "\nfix sums all output/objects every 10 file there/a.csv", "run": "run 10\nshell mv there gone\nrun 10"},
     ["output/objects", "cannot write 'there/a.csv'", "free disk space"]),
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
    ("forces after values that need no file", {"output": MEASURES + "every 10\nfix late all gravity 9.81 vector 0 -1 0", "thermo": "thermo_style custom step f_sums[11]\nthermo 10"}),
    ("multi-direct forcing", fluid("forcing multi 3")),
    ("all sides periodic", fluid("body_force 0 0.1", "p p p")),
    ("held in a stream", {"swell": "", "thermo": "thermo 5", "move": HOLD + "held",
                          "fluid": LINES["fluid"].replace("wall yhi velocity 0.1 0", "inflow xlo parabolic 0.1 0 outflow xhi slip yhi")}),
    ("unfix with set-up", {"thermo": "", "output": "", "run": "run 2\nunfix water\nrun 2\nrun 2 pre no"}),
]


class BadInput(ProgramTest):
    timeout = 30

    def run_row(self, row, ranks):
        name, change, _ = row
        return self.run_program(change if isinstance(change, str) else scene(**change), ranks=ranks, name=f"{name} {ranks}".replace(" ", "_"))

    def check(self, ranks, rows=ROWS, runs=False):
        """Two at a time: most of what a row takes is the start of its ranks."""
        with ThreadPoolExecutor(2) as pool:
            tasks = [pool.submit(self.run_row, row, ranks) for row in rows]
        for (name, _, words), task in zip(rows, tasks):
            with self.subTest(name, ranks=ranks):
                result = task.result()
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

    def test_a_jump_of_the_natural_size_is_warned_of(self):
        for law, expected in (("polynomial 0.21 until 1", 1), ("polynomial 0.201 until 1", 0), ("polynomial 1 until 1 gives ratio", 0)):
            with self.subTest(law):
                result = self.succeed(scene(**swell(law)), name=law.replace(" ", "_"))
                self.assertEqual(result.output.count("the natural diameter of object (molecule) 1 jumps by 5 %"), expected)
                self.assertEqual(result.output.count("jumps by"), expected)

    def test_what_stays_allowed(self):
        for name, change in STAYS_ALLOWED:
            for ranks in (1, 2):
                with self.subTest(name, ranks=ranks):
                    self.succeed(scene(**change), ranks=ranks, name=f"{name} {ranks}".replace(" ", "_"))


if __name__ == "__main__":
    unittest.main()
