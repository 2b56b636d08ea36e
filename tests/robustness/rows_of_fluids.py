"""Rows of test_bad_input.py: the fluid, what is held in it or moves as told, and scalars."""

from scene import LINES, with_word

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

SCALAR = "fix fresh fluid/scalar"


def carried(words, line=LINES["fluid"], **changes):
    """The scene with a scalar below its fluid."""
    return {"fluid": line + "\nfix fresh all fluid/scalar " + words, **changes}


SCALAR_ROWS = [
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

ROWS = FLUID_ROWS + HELD_ROWS + SCALAR_ROWS
