"""The program beside stock liggghts: same scripts, same command line, same numbers; plus what is our own."""

import shutil
import unittest

import caselib
from program import ProgramTest
from scene import scene

# 60 spheres fall on a plane and on a triangle that lies in it, in a periodic box; `parts` splits the run.
POUR = """
atom_style granular
atom_modify map array
boundary p p f
newton off
communicate single vel yes
units si
processors {processors}
region box block 0 0.1 0 0.1 0 0.12 units box
create_box 1 box
neighbor 0.002 bin
neigh_modify delay 0
fix m1 all property/global youngsModulus peratomtype 5.e6
fix m2 all property/global poissonsRatio peratomtype 0.45
fix m3 all property/global coefficientRestitution peratomtypepair 1 0.7
fix m4 all property/global coefficientFriction peratomtypepair 1 0.5
pair_style gran model hertz tangential history
pair_coeff * *
timestep 1e-5
fix gravity all gravity 9.81 vector 0.0 0.0 -1.0
fix floor all wall/gran model hertz tangential history primitive type 1 zplane 0.0
fix plate all mesh/surface file plate.stl type 1
fix plates all wall/gran model hertz tangential history mesh n_meshes 1 meshes plate
region fill block 0.01 0.09 0.01 0.09 0.02 0.11 units box
fix pts all particletemplate/sphere 15485863 atom_type 1 density constant 2500 radius constant 0.004
fix ptd all particledistribution/discrete 32452843 1 pts 1.0
fix insert all insert/pack seed 49979687 distributiontemplate ptd vel constant 0. 0. -0.5 insert_every once overlapcheck yes all_in yes particles_in_region 60 region fill
fix move all nve/sphere
compute energy all erotate/sphere
thermo_style custom step atoms ke c_energy
thermo_modify lost ignore norm no
thermo 200
dump positions all custom 500 dump.*.txt id type x y z vx vy vz radius
dump_modify positions sort id format "%d %d %.12g %.12g %.12g %.12g %.12g %.12g %.12g"
run 1000
write_restart bed.restart
run 1000
"""

CONTINUE = """
atom_style granular
atom_modify map array
boundary p p f
newton off
communicate single vel yes
units si
processors {processors}
read_restart ../pour_{who}/bed.restart
neighbor 0.002 bin
neigh_modify delay 0
fix m1 all property/global youngsModulus peratomtype 5.e6
fix m2 all property/global poissonsRatio peratomtype 0.45
fix m3 all property/global coefficientRestitution peratomtypepair 1 0.7
fix m4 all property/global coefficientFriction peratomtypepair 1 0.5
pair_style gran model hertz tangential history
pair_coeff * *
timestep 1e-5
fix gravity all gravity 9.81 vector 0.0 0.0 -1.0
fix floor all wall/gran model hertz tangential history primitive type 1 zplane 0.0
fix move all nve/sphere
thermo_style custom step atoms ke
thermo 100
run 500
"""

PLATE = """solid plate
facet normal 0 0 1
outer loop
vertex 0.02 0.02 0.01
vertex 0.08 0.02 0.01
vertex 0.05 0.08 0.012
endloop
endfacet
endsolid plate
"""

class SameAsStock(ProgramTest):
    def both(self, script, ranks, name):
        results = []
        for who, program in (("ours", caselib.program()), ("stock", shutil.which("liggghts"))):
            folder = f"{name}_{who}"
            (self.folder(folder) / "plate.stl").write_text(PLATE)
            results.append(self.succeed(script.replace("{who}", who), ranks=ranks, program=program, name=folder))
        return results

    def compare(self, ours, stock, thermo_rows):
        self.assertGreaterEqual(len(stock.thermo()), thermo_rows)
        self.assertEqual(ours.thermo(), stock.thermo())
        dumps = sorted(path.name for path in stock.folder.glob("dump.*"))
        self.assertEqual(dumps, sorted(path.name for path in ours.folder.glob("dump.*")))
        for dump in dumps:
            self.assertEqual((ours.folder / dump).read_text(), (stock.folder / dump).read_text(), dump)
        return dumps

    def check(self, ranks, processors):
        dumps = self.compare(*self.both(POUR.replace("{processors}", processors), ranks, "pour"), thermo_rows=12)
        self.assertEqual(len(dumps), 5)
        self.compare(*self.both(CONTINUE.replace("{processors}", processors), ranks, "continue"), thermo_rows=6)

    def test_pour_and_restart_on_1_rank(self):
        self.check(1, "* * *")

    def test_pour_and_restart_on_2_ranks(self):
        self.check(2, "1 * 1")


class CommandLine(ProgramTest):
    def test_standard_input_and_variables(self):
        for ranks in (1, 2):
            result = self.succeed(None, "-var", "a", "7", "-var", "b", "x", "y", ranks=ranks, stdin='print "got ${a} ${b}"\nnext b\nprint "then ${b}"\n')
            self.assertIn("got 7 x\n", result.output)
            self.assertIn("then y\n", result.output)

    def test_log_screen_and_echo(self):
        result = self.succeed('print "hello"\n', "-log", "other.log", "-screen", "screen.txt", "-echo", "both")
        self.assertNotIn("hello", result.output)
        self.assertEqual((result.folder / "screen.txt").read_text().count("hello"), 2)
        self.assertEqual((result.folder / "other.log").read_text().count("hello"), 2)
        self.assertEqual(result.log, "")

    def test_help_lists_our_styles_once(self):
        for ranks in (1, 2):
            result = self.run_program(None, "-help", ranks=ranks)  # stock liggghts, too, ends its help with exit code 1
            for style in ("fluid/ib", "held", "mass_spring", "nve/cds", "output/vtk", "prescribed", "swell", "create_objects"):
                self.assertEqual(result.output.count(f"  {style}\n"), 1, style)
            self.assertIn("wall/gran", result.output)

    def test_version(self):
        self.assertRegex(self.succeed(None, "--version").output, r"(?m)^swellflow \d+\.\d+\.\d+ \(LIGGGHTS 3\.8\.0\)$")

    def test_missing_script_is_an_error(self):
        for ranks in (1, 2):
            result = self.run_program(None, "-in", "nowhere", ranks=ranks)
            self.assertNotEqual(result.status, 0)
            self.assertIn("Cannot open input script nowhere", result.output)

    def test_error_in_the_script_is_the_exit_code(self):
        for ranks in (1, 2):
            self.assertNotEqual(self.run_program("no_such_command\n", ranks=ranks).status, 0)


class Decompositions(ProgramTest):
    def test_any_processors_line(self):
        alone = self.succeed(scene()).thermo()[-1]
        for ranks, grid in ((2, "2 1 1"), (2, "1 2 1"), (3, "3 1 1"), (3, "1 * 1"), (4, "2 2 1"), (4, "* * *")):
            with self.subTest(ranks=ranks, grid=grid):
                row = self.succeed(scene(boundary=f"processors {grid}\nboundary f f p"), ranks=ranks).thermo()[-1]
                for column, value in alone.items():
                    self.assertAlmostEqual(row[column], value, delta=1e-7 * abs(value), msg=column)


class Clear(ProgramTest):
    """`clear` rebuilds LIGGGHTS' table of fixes; ours must be in it whenever a box is."""

    def last_rows(self, script, ranks=1):
        """The last thermo row of each run."""
        rows = self.succeed(script, ranks=ranks).thermo()
        return [{**row, "Time": None} for row in rows if row["Step"] == 10]

    def test_scene_after_clear_is_the_same_scene(self):
        for ranks in (1, 2):
            first, second = self.last_rows(scene() + "clear\n" + scene(), ranks)
            self.assertEqual(first, second)

    def test_clear_within_one_line(self):
        commands = [line for line in scene().splitlines() if line]
        self.assertTrue(all('"' not in command for command in commands))
        line = 'if "1 == 1" then clear ' + " ".join(f'"{command}"' for command in commands) + "\n"
        first, second = self.last_rows(scene() + line)
        self.assertEqual(first, second)

    def test_jump_loop_with_clear_and_unfix(self):
        loop = "variable i loop 3\nlabel again\nclear\n" + scene() + \
               "unfix out\nunfix water\nunfix move\nunfix grow\nunfix springs\nnext i\njump in.script again\n"
        for ranks in (1, 2):
            rows = self.last_rows(loop, ranks)
            self.assertEqual(rows, 3 * rows[:1])

    def test_clear_before_read_restart(self):
        dry = {"fluid": "", "output": "", "thermo": "thermo_style custom step time ke f_grow[1]\nthermo 5"}
        save = scene(**dry) + "write_restart objects.restart\nrun 10\nclear\n"
        again = {"dimension": "dimension 2", "region": "", "box": "read_restart objects.restart", "objects": ""}
        for ranks in (1, 2):
            rows = self.succeed(save + scene(**{**dry, **again}), ranks=ranks).thermo()
            uninterrupted, continued = [row for row in rows if row["Step"] == 20]
            for column in ("KinEng", "grow[1]"):  # LIGGGHTS' own clock begins anew after read_restart
                self.assertEqual(uninterrupted[column], continued[column])

    def test_run_twice_and_unfix(self):
        script = scene() + "run 10\nunfix out\nunfix water\nthermo_style custom step time ke f_grow[1]\nrun 10\n"
        for ranks in (1, 2):
            self.assertEqual(self.succeed(script, ranks=ranks).thermo()[-1]["Step"], 30)


if __name__ == "__main__":
    unittest.main()
