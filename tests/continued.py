"""Scenes that go on from restart files, and how the unbroken run is compared with the one in two parts. Shared by the tests of restart files."""

import struct

import numpy as np

import scene
from program import ProgramTest

STEPS, MIDDLE = 120, 60
TOLERANCE = 1e-9  # between numbers of ranks

CONTACT = scene.LINES["contact"].replace("gamman_abs peratomtypepair 1 0", "gamman_abs peratomtypepair 1 1").replace("gammat_abs peratomtypepair 1 0", "gammat_abs peratomtypepair 1 0.5")
HARD = CONTACT.replace("peratomtypepair 1 1e4", "peratomtypepair 1 3e5")
GROUPS = "\ngroup odd molecule 1 3 5 7 9 11 13 15\ngroup even molecule 2 4 6 8 10 12 14 16"
SPREAD = " density 2000 cds 0.1 reach 0 sizes uniform 0.05 seed 1"
OBJECTS = ("create_objects lattice 2 4 origin 0.125 0.125 spacing 0.5 0.25 disk diameter 0.22 points 20" + SPREAD +
           "\ncreate_objects lattice 2 4 origin 0.375 0.125 spacing 0.5 0.25 ellipse axes 0.24 0.2 points 20 density 1200 cds 0.1 reach 0" + GROUPS)
DISCS = "create_objects lattice 4 4 origin 0.125 0.125 spacing 0.25 disk diameter {} points 20" + SPREAD
FEW = "create_objects lattice 2 2 origin 0.35 0.3 spacing 0.3 0.4 disk diameter 0.2 points 20 density 1500 cds 0.1 reach 0"
MEMBRANES = "create_objects lattice 3 3 origin 0.17 0.17 spacing 0.33 ellipse axes 0.3 0.22 points 24 density 1000 spokes no cds 0.05"
BED = "create_objects random solid_fraction 0.55 within box disk diameter 0.12 points 16 density 1100 cds 0.1 reach 0 seed 7 sizes lognormal 0.1 seed 8"
HELD_TOGETHER = "fix springs all mass_spring stiffness 2000 restitution 0.9"
SPRINGS = HELD_TOGETHER + "\nfix weight all gravity 3 vector 0.3 -1 0"
WALL = "\nfix {0} all wall/gran model hooke/stiffness tangential history primitive type 1 {1} absolute_damping on"
WALLS = WALL.format("low", "yplane 0.0") + WALL.format("high", "yplane 1.0")
MESH_FILE = "floor.stl"
MESH = (f"\nfix floor all mesh/surface file {MESH_FILE} type 1 curvature 1e-5"
        "\nfix wall all wall/gran model hooke/stiffness tangential history mesh n_meshes 1 meshes floor absolute_damping on")
MEASURES = "fix sums all output/objects every 60"

THERMO = ("thermo_style custom step time ke f_water f_water[1] f_water[2] f_water[3] f_water[4] f_water[6] f_water[7] f_water[9] f_water[10] f_water[12] f_water[15] f_water[19]{}\n"
          "thermo_modify format float %.17g\nthermo 60")
DRY_THERMO = "thermo_style custom step time ke{}\nthermo_modify format float %.17g\nthermo 60"

BASE = {"contact": CONTACT, "objects": OBJECTS, "springs": SPRINGS, "timestep": "timestep 1e-3", "thermo": THERMO.format(""), "output": "", "swell": ""}
FLUID = "fix water all fluid/ib cells 48 48 density 1000 viscosity 1e-2 every 2 "
EXPLICIT, IMPLICIT = "fix move all nve/cds\nfix flat all enforce2d", "fix move all nve/cds implicit\nfix flat all enforce2d"
THICK = "region box block 0 1 0 1 -0.5 0.5 units box"  # LIGGGHTS stumbles over meshes in thin boxes

SCENES = {
    "soft, swelling, periodic": {"boundary": "boundary p p p", "fluid": FLUID + "body_force 0.3 0.1", "map": "atom_modify map array sort 17 0",
                                 "move": EXPLICIT + "\nfix grow all swell linear rate 0.1 max 0.3 scatter 0.2 0.1 seed 3 load 5e3"},
    "implicit and rigid, driven": {"boundary": "boundary p f p", "springs": SPRINGS + WALLS, "move": "fix move odd nve/cds implicit\nfix stiff even rigid/cds\nfix flat all enforce2d",
                                   "fluid": FLUID + "mean_velocity x 0.05 forcing multi 3", "swell": "fix grow odd swell linear rate 0.1 max 0.3"},
    "pushed away, adaptive": {"boundary": "boundary f f p", "objects": FEW, "springs": HELD_TOGETHER, "move": EXPLICIT,
                              "fluid": "variable in equal 0.05*(1+0.5*sin(20*time))\n" + FLUID.replace("every 2", "every 7 cfl 0.4") + "inflow xlo uniform v_in 0 outflow xhi slip ylo slip yhi",
                              "swell": "fix grow all swell linear rate 0.1 max 0.3 absorb no"},
    "held, prescribed, a scalar": {"boundary": "boundary p f p", "springs": "", "move": "variable turn equal 3*cos(20*time)\nfix hold odd held\nfix turn even prescribed spin v_turn",
                                   "fluid": FLUID + "wall yhi velocity 0.2 0\nfix dye all fluid/scalar diffusivity 1e-3 initial 0 value ylo 1"},
    "dry": {"boundary": "boundary p f p", "springs": SPRINGS + WALLS, "move": EXPLICIT, "fluid": "", "swell": "fix grow all swell linear rate 0.1 max 0.3", "thermo": DRY_THERMO.format("")},
    "outgrows its cut-offs": {"boundary": "boundary p p p", "objects": DISCS.format(0.12), "fluid": FLUID + "body_force 0.3 0.1", "thermo": THERMO.format(" f_grow[3]"),
                              "move": EXPLICIT + "\nfix grow all swell linear rate 0.8 max 0.22 scatter 0.2 0.1 seed 3 load 5e3"},
    "on a mesh": {"boundary": "boundary f f p", "region": THICK, "contact": HARD, "springs": SPRINGS.replace("gravity 3", "gravity 30") + MESH, "move": EXPLICIT,
                  "objects": "create_objects lattice 4 2 origin 0.14 0.30 spacing 0.24 0.24 disk diameter 0.22 points 20" + SPREAD, "output": MEASURES, "thermo": THERMO.format(" f_sums[12]"),
                  "fluid": FLUID.replace("48 48", "32 32"), "swell": "fix grow all swell linear rate 0.2 max 0.3"},
    "membranes": {"boundary": "boundary p f p", "objects": MEMBRANES, "springs": HELD_TOGETHER.replace("2000", "20000"), "move": IMPLICIT, "swell": "fix grow all swell linear rate 0.1 max 0.3",
                  "fluid": FLUID + "wall ylo velocity -2 0 wall yhi velocity 2 0 initial_velocity linear"},
    "lubricated": {"boundary": "boundary p f p", "objects": DISCS.format(0.225) + GROUPS, "springs": SPRINGS + "\nfix gaps all lubrication/cds viscosity 10 cutoff 0.026 minimum 1e-4",
                   "move": "fix move odd nve/cds\nfix stiff even rigid/cds\nfix flat all enforce2d", "fluid": FLUID + "body_force 3 0.1", "thermo": THERMO.format(" f_gaps[1]")},
    "a random bed, fed": {"boundary": "boundary p p p", "objects": BED, "springs": HELD_TOGETHER, "move": IMPLICIT, "thermo": THERMO.format(" f_fresh[7]"),
                          "fluid": FLUID + "pressure_drop 0 -2000\nfix fresh all fluid/scalar diffusivity 1e-3 initial 0.3 feed yhi 1\n"
                          "fix grow all swell tanaka_fillmore final 1.3 tau 0.5 gives ratio fed_by fresh load 5e3 scatter 0.2 0.1 seed 3"},
}

DUMP = "\ndump end all custom 1 end.dump id x y vx vy mass radius\ndump_modify end sort id format \"%d %.17g %.17g %.17g %.17g %.17g %.17g\"\nrun 0\n"


def whole(lines, run):
    return scene.scene(**{**BASE, **lines, "run": run})


def resumed(lines, file, run):
    """The same script with the box and the objects from a restart file, and the fluid as it is."""
    again = {**BASE, **lines, "run": run}
    groups = "\n".join(line for line in again["objects"].splitlines() if line.startswith("group"))
    again.update(box=f"read_restart {file}", region="", objects=groups)
    return scene.scene(**again)


def end_of(result):
    return np.loadtxt(result.folder / "end.dump", skiprows=9)


def fluid_in(file):
    """The arrays that a restart file holds of the fluid; its last 32 bytes tell where they begin and end."""
    data = file.read_bytes()
    _, at, length, _ = struct.unpack("<qqqQ", data[-32:])
    arrays = {}
    while at < length - 48:
        size, = struct.unpack_from("<q", data, at)
        name = data[at + 8:at + 8 + size].decode()
        count, = struct.unpack_from("<q", data, at + 8 + size)
        at += 16 + size
        arrays[name] = np.frombuffer(data, "<f8", count, at)
        at += 8 * count
    return arrays


def mesh():
    """A strip of 20 triangles that rises from the left to the right."""
    corners = [(0.02 + 0.096 * k, 0.1 + 0.01 * k) for k in range(11)]
    lines = ["solid floor"]
    for (x, y), (right, up) in zip(corners, corners[1:]):
        for triangle in (((x, y, -0.05), (right, up, -0.05), (right, up, 0.05)), ((x, y, -0.05), (right, up, 0.05), (x, y, 0.05))):
            lines += ["facet normal 0 1 0", "outer loop", *("vertex {:g} {:g} {:g}".format(*corner) for corner in triangle), "endloop", "endfacet"]
    return "\n".join([*lines, "endsolid floor"]) + "\n"


class ContinuedTest(ProgramTest):
    """What is compared: every point, and all that the fluid is, as another restart file has it."""

    def first_part(self, lines, ranks):
        """The unbroken run; it leaves a restart file of its middle."""
        name = f"from{ranks}"
        (self.folder(name) / MESH_FILE).write_text(mesh())
        first = self.succeed(whole(lines, f"restart {MIDDLE} state.*\nrun {STEPS}\nrestart 0\nwrite_restart whole.restart" + DUMP), ranks=ranks, name=name)
        (first.folder / "end.dump").rename(first.folder / "whole.dump")
        return first

    def second_part(self, lines, written_on, ranks, file=f"state.{MIDDLE}"):
        again = f"restart {MIDDLE} later.*\nrun {STEPS - MIDDLE}\nrestart 0\nwrite_restart end.restart"
        return self.succeed(resumed(lines, file, again + DUMP), ranks=ranks, name=f"from{written_on}")

    def goes_on(self, name, written_on, continued_on):
        """Returns what the unbroken run says of its start, middle and end."""
        lines = SCENES[name]
        first = self.first_part(lines, written_on)
        said = first.thermo()[:3]
        unbroken = np.loadtxt(first.folder / "whole.dump", skiprows=9)
        for ranks in continued_on:
            with self.subTest(name, written_on=written_on, ranks=ranks):
                end = end_of(self.second_part(lines, written_on, ranks))
                if ranks == written_on:
                    self.assertTrue(np.array_equal(unbroken, end))
                    before, after = fluid_in(first.folder / "whole.restart"), fluid_in(first.folder / "end.restart")
                    self.assertEqual([key for key in before if not np.array_equal(before[key], after[key])], [])
                    self.assertEqual(before.keys(), after.keys())
                    self.assertEqual(len(before) > 0, lines["fluid"] != "")
                else:
                    self.assertLess(np.max(np.abs(unbroken - end) / np.max(np.abs(unbroken), axis=0)), TOLERANCE)
        return said
