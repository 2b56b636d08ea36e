#!/usr/bin/python3
"""decomposition.py FOLDER [SCENE...]: scenes end alike however the ranks share the box.

Objects swell, touch and rub, cross every kind of border between ranks, and lie across corners of four of them, for 500 fluid steps; asserted to 1e-8 of each array's largest value.
"""

import subprocess
import sys
from dataclasses import dataclass, replace
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "cases"))
import numpy as np  # noqa: E402

import caselib  # noqa: E402
import frames  # noqa: E402

GRIDS = ((1, 1), (2, 1), (1, 2), (3, 1), (1, 3), (2, 2), (4, 1), (1, 4))  # ranks along x and y; the first is what the others are compared with
BORDERS = (0.0, 1 / 4, 1 / 3, 1 / 2, 2 / 3, 3 / 4)                         # between their parts of the box, and its periodic side
EVERY = 2          # DEM steps a fluid step
READ = 5           # fluid steps between lines of objects.csv
TOLERANCE = 1e-8

SCRIPT = """
units si
dimension 2
processors {grid[0]} {grid[1]} 1
atom_style hybrid granular molecular
atom_modify map array
boundary {sides}
newton off
communicate single vel yes
soft_particles yes
region box block 0 1 0 1 -0.005 0.005 units box
create_box 1 box
neighbor 0.01 bin
neigh_modify delay 0 exclude molecule all
fix kn all property/global kn peratomtypepair 1 2e4
fix kt all property/global kt peratomtypepair 1 2e4
fix gn all property/global gamman_abs peratomtypepair 1 1
fix gt all property/global gammat_abs peratomtypepair 1 0.5
fix mu all property/global coefficientFriction peratomtypepair 1 {friction}
pair_style gran model hooke/stiffness tangential history absolute_damping on
pair_coeff * *
create_objects lattice 2 4 origin 0.125 0.125 spacing 0.5 0.25 disk diameter 0.21 points 20 density 2000 cds 0.1 reach 0 sizes uniform 0.08 seed 1
create_objects lattice 2 4 origin 0.375 0.125 spacing 0.5 0.25 ellipse axes 0.23 0.19 points 20 density 1200 cds 0.1 reach 0 sizes uniform 0.08 seed 2
group first molecule 1 4 7 10 13 16
group second molecule 2 5 8 11 14
group third molecule 3 6 9 12 15
{walls}
fix weight all gravity {gravity} vector 0.3 -1 0
fix springs all mass_spring stiffness 2000 restitution 0.9
fix move1 first {integrators[0]}
fix move2 second {integrators[1]}
fix move3 third {integrators[2]}
fix flat all enforce2d
fix water all fluid/ib cells {cells} {cells} density 1000 viscosity 1e-2 every {every} {flow}
fix grow all swell linear rate 0.12 max {final} scatter 0.2 0.1 seed 3 load 5e3
fix measures all output/objects every {read} file objects.csv
fix end all output/vtk every {total} folder post fields velocity pressure objects points
thermo_style custom step time f_grow[2] f_water[5] f_measures[2]
thermo_modify format float %.17g
thermo {total}
timestep 1e-3
run {total}
"""

MIXED = ("nve/cds", "nve/cds implicit", "rigid/cds")

WALLS = """
fix bottom all wall/gran model hooke/stiffness tangential history primitive type 1 yplane 0.0 shear x -1.2 absolute_damping on
fix top all wall/gran model hooke/stiffness tangential history primitive type 1 yplane 1.0 shear x 1.2 absolute_damping on
velocity all ramp vx -1.2 1.2 y 0 1 units box
"""


@dataclass(frozen=True)
class Scene:
    """16 discs and ellipses, each third moved by its own integrator, in a box of side 1."""
    sides: str
    flow: str
    walls: str
    gravity: float
    final: float  # natural diameter of an average object
    integrators: tuple = MIXED
    friction: float = 0.5
    cells: int = 48
    fluid_steps: int = 500

    def script(self, grid):
        return SCRIPT.format(grid=grid, every=EVERY, read=READ * EVERY, total=EVERY * self.fluid_steps, **vars(self))


# Periodic both ways; the stream carries all of them across every border while the heavy ones sink among the light ones.
DRIFT = Scene(sides="p p p", flow="mean_velocity x 1.2 mean_velocity y 0.9 initial_velocity 1.2 0.9", walls="velocity all set 1.2 0.9 0 units box", gravity=10, final=0.27)
# Between walls that slide past each other and rub on them.
SHEAR = Scene(sides="p f p", flow="wall ylo velocity -1.2 0 wall yhi velocity 1.2 0 initial_velocity linear", walls=WALLS, gravity=15, final=0.24)

SCENES = {"drift": DRIFT, "shear": SHEAR,
          **{f"{name}_{integrator.replace('/', '_').replace(' ', '_')}": replace(scene, integrators=3 * (integrator,))
             for name, scene in (("drift", DRIFT), ("shear", SHEAR)) for integrator in MIXED},
          "drift_fine": replace(DRIFT, cells=96, fluid_steps=1000)}


def run(scene, grid, folder):
    """The finished run's folder. What it says is in `screen`."""
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "in.scene").write_text(scene.script(grid))
    command = ["mpirun", "--oversubscribe", "-np", str(grid[0] * grid[1]), str(caselib.program()), "-in", "in.scene"]
    with open(folder / "screen", "w") as screen:
        status = subprocess.run(command, cwd=folder, env=caselib.mpi_environment(grace=0), stdin=subprocess.DEVNULL, stdout=screen, stderr=subprocess.STDOUT, timeout=600).returncode
    if status:
        raise RuntimeError(f"{' '.join(command)} in {folder}:\n{(folder / 'screen').read_text(errors='replace')[-2000:]}")
    return folder


class State:
    """Points, fluid and objects at the end of a run, each {name: array}."""

    def __init__(self, folder):
        def last(name):
            return frames.Series(folder / "post", name).frames[-1][1]

        positions, values = frames.vertices(last("points"))
        order = np.argsort(values["tag"])
        _, _, fields = frames.fields(last("fields"))
        self.objects = caselib.read_csv(folder / "objects.csv")
        self.positions = positions[order, :2]
        end = [row for row in self.objects if row["step"] == self.objects[-1]["step"]]
        self.arrays = {"point velocity": values["velocity"][order], "fluid velocity": fields["velocity"], "fluid pressure": fields["pressure"],
                       "kinetic energy of the fluid": np.array([caselib.read_thermo(folder / "log.liggghts")[-1]["water[5]"]]),
                       **{words: np.array([row[column] for row in end]) for words, column in
                          (("mean diameter [m]", "mean_diameter [m]"), ("natural diameter", "natural_diameter [m]"), ("contact pressure", "contact_pressure [Pa]"))}}

    def differences(self, other):
        """{name: largest difference over the largest value}; a point may be on either side of a periodic box of side 1."""
        apart = self.positions - other.positions
        return {"position": float(np.abs(apart - np.round(apart)).max()),
                **{name: float(np.abs(array - other.arrays[name]).max() / np.abs(array).max()) for name, array in self.arrays.items()}}


class Course:
    """Where objects went and what they touched, by the lines of objects.csv: arrays by reading and object."""

    def __init__(self, rows):
        ids = len({row["id"] for row in rows})
        self.place = {axis: self.column(rows, f"centroid_{axis} [m]", ids) for axis in "xy"}
        self.size = self.column(rows, "mean_diameter [m]", ids)
        self.partners = self.column(rows, "coordination", ids)
        self.force = self.column(rows, "contact_force [N]", ids)

    @staticmethod
    def column(rows, name, ids):
        return np.array([row[name] for row in rows]).reshape(-1, ids)

    def crossings(self, axis, border):
        """How often the middle of an object changed sides of a border, or of its periodic images; between two readings it moves far less than half a box."""
        unwrapped = np.unwrap(self.place[axis], period=1.0, axis=0)
        return int(np.abs(np.diff(np.floor(unwrapped - border), axis=0)).sum())

    def across(self, axis, border):
        """Where an object lies on both sides of a border."""
        apart = self.place[axis] - border
        return np.abs(apart - np.round(apart)) < 0.4 * self.size

    def touching(self):
        return self.partners > 0

    def at_walls(self):
        return (self.partners == 0) & (self.force > 1e-3)


def compare(table, name, scene, folder):
    """The largest difference of any grid from one rank, as a line a grid of the table."""
    alone = State(run(scene, GRIDS[0], folder / "1x1"))
    worst = 0.0
    for grid in GRIDS[1:]:
        differences = alone.differences(State(run(scene, grid, folder / f"{grid[0]}x{grid[1]}")))
        where = max(differences, key=differences.get)
        table.at_most(f"{name}, {grid[0]} x {grid[1]} ranks against one: {where}", differences[where], TOLERANCE)
        worst = max(worst, *differences.values())
    return worst


def main(folder, names):
    table = caselib.Table()
    worst = [compare(table, name, SCENES[name], folder / name) for name in names or SCENES]
    table.finish("largest relative difference", max(worst))


if __name__ == "__main__":
    main(Path(sys.argv[1]).absolute(), sys.argv[2:])
