"""A small scene with one of everything, line by line, so that a test can change one line and keep the rest."""

LINES = {
    "units": "units si",
    "dimension": "dimension 2",
    "atoms": "atom_style hybrid granular molecular",
    "map": "atom_modify map array",
    "boundary": "boundary f f p",
    "newton": "newton off",
    "ghosts": "communicate single vel yes",
    "soft": "soft_particles yes",
    "region": "region box block 0 1 0 1 -0.005 0.005 units box",
    "box": "create_box 1 box",
    "neighbor": "neighbor 0.01 bin\nneigh_modify delay 0 exclude molecule all",
    "contact": "fix kn all property/global kn peratomtypepair 1 1e4\n"
               "fix kt all property/global kt peratomtypepair 1 1e4\n"
               "fix gn all property/global gamman_abs peratomtypepair 1 0\n"
               "fix gt all property/global gammat_abs peratomtypepair 1 0\n"
               "fix mu all property/global coefficientFriction peratomtypepair 1 0.3",
    "pair": "pair_style gran model hooke/stiffness tangential history absolute_damping on\npair_coeff * *",
    "objects": "create_objects lattice 2 2 origin 0.3 0.3 spacing 0.4 disk diameter 0.2 points 16 density 1500 cds 0.2 type 1",
    "springs": "fix springs all mass_spring stiffness 1000 restitution 1.0",
    "swell": "fix grow all swell linear rate 6e-4 max 0.25",
    "move": "fix move all nve/cds\nfix flat all enforce2d",
    "fluid": "fix water all fluid/ib cells 32 32 density 1000 viscosity 1e-2 every 2 wall yhi velocity 0.1 0",
    "output": "fix out all output/vtk every 10 folder post fields velocity pressure objects outline points cds",
    "thermo": "thermo_style custom step time ke f_grow[1] f_water[1]\nthermo 5",
    "timestep": "timestep 1e-3",
    "run": "run 10",
}


def scene(**changes):
    """The whole script; a keyword replaces the line of that name, and an empty one leaves it out."""
    unknown = set(changes) - set(LINES)
    assert not unknown, f"no such line: {unknown}"
    return "\n".join({**LINES, **changes}.values()) + "\n"


def moved(name, behind):
    """The whole script with one line moved behind another."""
    names = [key for key in LINES if key != name]
    names.insert(names.index(behind) + 1, name)
    return "\n".join(LINES[key] for key in names) + "\n"


def with_word(line, old, new):
    """The change of one line by one word."""
    assert old in LINES[line], (line, old)
    return {line: LINES[line].replace(old, new)}


def dry(**changes):
    """The scene without a fluid and what needs one."""
    return {"fluid": "", "output": "", "swell": "", "thermo": "thermo 5", **changes}
