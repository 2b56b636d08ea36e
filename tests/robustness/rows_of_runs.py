"""Rows of test_bad_input.py: what would end without a word or never, what shows during a run only, and what stays allowed."""

from rows_of_fluids import HOLD, fluid
from rows_of_objects import GROW, MEASURES, PLACE, at_random
from scene import LINES, dry, moved, with_word

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
