#!/usr/bin/python3
"""A run that goes on from a restart file equals the one that was not interrupted: to the last bit on the same ranks, to 1e-9 on others."""

import struct
import subprocess
import unittest

import numpy as np

import caselib
import scene
from program import ProgramTest

STEPS, MIDDLE = 120, 60
TOLERANCE = 1e-9

CONTACT = scene.LINES["contact"].replace("gamman_abs peratomtypepair 1 0", "gamman_abs peratomtypepair 1 1").replace("gammat_abs peratomtypepair 1 0", "gammat_abs peratomtypepair 1 0.5")
OBJECTS = ("create_objects lattice 2 4 origin 0.125 0.125 spacing 0.5 0.25 disk diameter 0.22 points 20 density 2000 cds 0.1 reach 0 sizes uniform 0.05 seed 1\n"
           "create_objects lattice 2 4 origin 0.375 0.125 spacing 0.5 0.25 ellipse axes 0.24 0.2 points 20 density 1200 cds 0.1 reach 0\n"
           "group odd molecule 1 3 5 7 9 11 13 15\ngroup even molecule 2 4 6 8 10 12 14 16")
FEW = "create_objects lattice 2 2 origin 0.35 0.3 spacing 0.3 0.4 disk diameter 0.2 points 20 density 1500 cds 0.1 reach 0"
SPRINGS = "fix springs all mass_spring stiffness 2000 restitution 0.9\nfix weight all gravity 3 vector 0.3 -1 0"
WALL = "\nfix {0} all wall/gran model hooke/stiffness tangential history primitive type 1 {1} absolute_damping on"
WALLS = WALL.format("low", "yplane 0.0") + WALL.format("high", "yplane 1.0")
THERMO = ("thermo_style custom step time ke f_water f_water[1] f_water[2] f_water[3] f_water[4] f_water[6] f_water[7] f_water[9] f_water[10] f_water[12] f_water[15] f_water[19]\n"
          "thermo_modify format float %.17g\nthermo 60")

BASE = {"contact": CONTACT, "objects": OBJECTS, "springs": SPRINGS, "timestep": "timestep 1e-3", "thermo": THERMO, "output": ""}
FLUID = "fix water all fluid/ib cells 48 48 density 1000 viscosity 1e-2 every 2 "

SCENES = {
    "soft, swelling, periodic": {"boundary": "boundary p p p", "swell": "", "fluid": FLUID + "body_force 0.3 0.1",
                                 "move": "fix move all nve/cds\nfix flat all enforce2d\nfix grow all swell linear rate 0.1 max 0.3 scatter 0.2 0.1 seed 3 load 5e3"},
    "implicit and rigid, driven": {"boundary": "boundary p f p", "springs": SPRINGS + WALLS, "move": "fix move odd nve/cds implicit\nfix stiff even rigid/cds\nfix flat all enforce2d",
                                   "fluid": FLUID + "mean_velocity x 0.05 forcing multi 3", "swell": "fix grow odd swell linear rate 0.1 max 0.3"},
    "pushed away, adaptive": {"boundary": "boundary f f p", "objects": FEW, "springs": SPRINGS.splitlines()[0], "move": "fix move all nve/cds\nfix flat all enforce2d",
                              "fluid": "variable in equal 0.05*(1+0.5*sin(20*time))\n" + FLUID.replace("every 2", "every 7 cfl 0.4") + "inflow xlo uniform v_in 0 outflow xhi slip ylo slip yhi",
                              "swell": "fix grow all swell linear rate 0.1 max 0.3 absorb no"},
    "held, prescribed, a scalar": {"boundary": "boundary p f p", "springs": "", "swell": "", "move": "variable turn equal 3*cos(20*time)\nfix hold odd held\nfix turn even prescribed spin v_turn",
                                   "fluid": FLUID + "wall yhi velocity 0.2 0\nfix dye all fluid/scalar diffusivity 1e-3 initial 0 value ylo 1"},
    "dry": {"boundary": "boundary p f p", "springs": SPRINGS + WALLS, "move": "fix move all nve/cds\nfix flat all enforce2d", "fluid": "", "swell": "fix grow all swell linear rate 0.1 max 0.3",
            "thermo": "thermo_style custom step time ke\nthermo_modify format float %.17g\nthermo 60"},
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


class Continued(ProgramTest):
    """What is compared: every point, and all that the fluid is, as another restart file has it."""

    def first_part(self, lines, ranks):
        first = self.succeed(whole(lines, f"restart {MIDDLE} state.*\nrun {STEPS}\nrestart 0\nwrite_restart whole.restart" + DUMP), ranks=ranks, name=f"from{ranks}")
        (first.folder / "end.dump").rename(first.folder / "whole.dump")
        return first

    def second_part(self, lines, written_on, ranks, file=f"state.{MIDDLE}"):
        again = f"restart {MIDDLE} later.*\nrun {STEPS - MIDDLE}\nrestart 0\nwrite_restart end.restart"
        return self.succeed(resumed(lines, file, again + DUMP), ranks=ranks, name=f"from{written_on}")

    def check(self, name, continued_on):
        """`continued_on`: on how many ranks, by those that the file is written on."""
        lines = SCENES[name]
        for written_on, others in continued_on.items():
            first = self.first_part(lines, written_on)
            unbroken = np.loadtxt(first.folder / "whole.dump", skiprows=9)
            for ranks in others:
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

    def test_soft_objects_that_swell_in_a_periodic_box(self):
        self.check("soft, swelling, periodic", {1: (1, 2), 4: (4, 2)})

    def test_implicit_and_rigid_objects_and_a_held_flow_rate(self):
        self.check("implicit and rigid, driven", {2: (2, 1)})

    def test_objects_that_push_fluid_away_and_steps_that_are_chosen(self):
        self.check("pushed away, adaptive", {2: (2, 1)})

    def test_objects_that_move_as_told_and_a_scalar(self):
        self.check("held, prescribed, a scalar", {2: (2, 4)})

    def test_no_fluid(self):
        self.check("dry", {1: (1, 2)})


class Between(ProgramTest):
    def test_a_file_between_runs(self):
        """The run that follows sets up anew, with the file as without it."""
        lines = SCENES["implicit and rigid, driven"]
        run = f"run {MIDDLE}\nwrite_restart middle.restart\nrun {MIDDLE}\nwrite_restart whole.restart"
        first = self.succeed(whole(lines, run), ranks=2)
        self.succeed(resumed(lines, "middle.restart", f"run {MIDDLE}\nwrite_restart end.restart"), ranks=2)
        before, after = fluid_in(first.folder / "whole.restart"), fluid_in(first.folder / "end.restart")
        self.assertEqual([key for key in before if not np.array_equal(before[key], after[key])], [])


class Files(ProgramTest):
    LINES = SCENES["soft, swelling, periodic"]

    def setUp(self):
        super().setUp()
        self.made = self.succeed(whole(self.LINES, "write_restart good.0\nrun 2\nwrite_restart good.*"))
        self.file = self.made.folder / "good.2"
        self.data = self.file.read_bytes()

    def refused(self, words, file, **changes):
        result = self.run_program(resumed({**self.LINES, **changes}, file, "run 2"), ranks=2)
        self.assertNotEqual(result.status, 0)
        self.assertEqual(result.output.count("ERROR:"), 1, result.output[-1500:])
        for word in words:
            self.assertIn(word, result.output)

    def test_damaged(self):
        for at in (1000, len(self.data) // 2, len(self.data) - 10):
            with self.subTest(at):
                (self.made.folder / "bad").write_bytes(self.data[:at] + bytes([self.data[at] ^ 1]) + self.data[at + 1:])
                self.refused(["read_restart", "'bad'", "damaged"], "bad")

    def test_cut_short(self):
        for length in (300, len(self.data) // 3, len(self.data) - 1):
            with self.subTest(length):
                (self.made.folder / "bad").write_bytes(self.data[:length])
                self.refused(["read_restart", "'bad'", f"{length} bytes", "cut short"], "bad")

    def test_foreign(self):
        (self.made.folder / "bad").write_text("a text\n" * 100)
        self.refused(["'bad'", "no restart file"], "bad")
        self.refused(["'nothing'", "No such file"], "nothing")
        self.refused(["'per_rank.%'", "leave it out"], "per_rank.%")

    def test_of_another_fluid(self):
        self.refused(["fix water fluid/ib", "number of cells in x", "48 in the file", "64 here"], "good.2", fluid=self.LINES["fluid"].replace("48 48", "64 64"))

    def test_the_newest_that_is_whole(self):
        (self.made.folder / "good.3").write_bytes(self.data[:-100])
        (self.made.folder / "good.4.writing").write_bytes(self.data)
        result = self.succeed(resumed(self.LINES, "good.*", "run 2"), ranks=2)
        self.assertIn("'good.3' ends after", result.output)
        self.assertIn("good.2: complete, with a fluid", result.output)

    def test_a_file_of_liggghts_itself(self):
        box = "\n".join(scene.LINES[key] for key in ("units", "dimension", "atoms", "map", "boundary", "newton", "region", "box"))
        self.succeed(box + "\ncreate_atoms 1 single 0.5 0.5 0\nset group all density 1000 diameter 0.1\nwrite_restart stock.restart\n", program="liggghts")
        result = self.succeed("atom_modify map array\nread_restart stock.restart\nwrite_restart ours.restart\n")
        self.assertIn("no checksum, no fluid", result.output)
        self.succeed("atom_modify map array\nread_restart ours.restart\n", program="liggghts")


class Writing(ProgramTest):
    LINES = SCENES["soft, swelling, periodic"]

    def fails(self, run, words):
        result = self.run_program(whole(self.LINES, run), ranks=2)
        self.assertNotEqual(result.status, 0)
        for word in words:
            self.assertIn(word, result.output)
        return result

    def test_within_a_fluid_step(self):
        self.fails("restart 15 state.*\nrun 30", ["'restart 15' falls within one", "every 2", "multiple"])
        self.fails("run 15\nwrite_restart state", ["this run ends 1 of 2 DEM steps", "write_restart: restart files are written between fluid steps, but step 15", "multiple of 'every'"])

    def test_one_a_rank(self):
        self.fails("restart 10 state.%\nrun 10", ["'state.%.*'", "leave it out"])
        self.fails("write_restart state.%", ["'state.%'", "leave it out"])

    def test_folder_that_is_not_there(self):
        self.fails("restart 10 state.*\nrun 10\nrestart 0\nrestart 10 gone/state.*\nrun 10", ["'gone/state.20", "No such file", "last good one is 'state.10'"])

    def test_no_room(self):
        """Files may not be as large as this one would be; MPI's own are smaller."""
        script = whole({**self.LINES, "fluid": self.LINES["fluid"].replace("48 48", "400 400")}, "restart 2 state.*\nrun 4")
        self.folder("full").joinpath("in.script").write_text(script)
        command = f"ulimit -f 6000; exec {caselib.program()} -in in.script"
        done = subprocess.run(["bash", "-c", command], cwd=self.folder("full"), env=caselib.mpi_environment(grace=0), stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=60)
        output = done.stdout.decode(errors="replace")
        self.assertNotEqual(done.returncode, 0)
        self.assertIn("must be written in full", output)
        self.assertEqual(list(self.folder("full").glob("state*")), [])


if __name__ == "__main__":
    unittest.main(verbosity=2)
