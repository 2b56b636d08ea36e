"""Rows of test_bad_input.py: measures, swelling, shapes, and objects at random."""

from scene import LINES, dry, with_word

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

ROWS = MEASURE_ROWS + SWELL_ROWS + SHAPE_ROWS + RANDOM_ROWS
