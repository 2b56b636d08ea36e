"""Frames from scripts: when they are written, what they hold on one rank and on several, and what a wrong line says."""

import shutil
import unittest

import numpy as np

import frames
from program import ProgramTest

# Three objects that drift through a periodic box and grow; one starts across the left side.
BOX = """
units si
dimension 2
atom_style hybrid granular molecular
atom_modify map array sort 0 0
boundary p f p
newton off
communicate single vel yes
processors {processors}
region box block 0 1 0 1 -0.005 0.005 units box
create_box 1 box
neighbor 0.01 bin
neigh_modify delay 0 exclude molecule all
timestep 1e-3
"""
OBJECTS = BOX + """
create_objects disk 0.01 0.3 diameter 0.2 points 12 density 1500 cds 0.2 type 1
create_objects disk 0.4 0.5 diameter 0.1 points 20 density 1500 cds 0.2 type 1
create_objects disk 0.7 0.75 diameter 0.3 points 24 density 1500 cds 0.2 type 1
"""
DYNAMICS = """
fix springs all mass_spring stiffness 1000
fix grow all swell linear rate 0.05 max 0.4
fix move all nve/cds
fix flat all enforce2d
"""
DRIFT = "velocity all set -0.5 0.1 0\n"
WATER = "fix water all fluid/ib cells 16 16 density 1000 viscosity 0.01 every 2\n"
CLOSED = BOX.replace("boundary p f p", "boundary f f p")


def script(*parts, processors="* * 1"):
    return "".join(parts).replace("{processors}", processors)


class FramesTest(ProgramTest):
    def frames(self, result, name, folder="post"):
        return frames.Series(result.folder / folder, name).frames

    def times(self, result, name="outline", folder="post"):
        return [round(time, 9) for time, _ in self.frames(result, name, folder)]


class WhenFramesAreWritten(FramesTest):
    def test_a_second_run_neither_repeats_nor_skips(self):
        output = "fix out all output/vtk every 20 objects outline\n"
        result = self.succeed(script(OBJECTS, DYNAMICS, output, "run 30\nrun 10\nrun 25\n"))
        self.assertEqual(self.times(result), [0.0, 0.02, 0.04, 0.06])

    def test_unfix_and_fix_again_go_on_in_the_same_folder(self):
        output = "fix out all output/vtk every 20 objects outline\n"
        result = self.succeed(script(OBJECTS, DYNAMICS, output, "run 40\nunfix out\nrun 20\n", output, "run 20\n"))
        self.assertEqual(self.times(result), [0.0, 0.02, 0.04, 0.06, 0.08])

    def test_a_run_from_a_restart_file_replaces_later_frames_only(self):
        output = "fix out all output/vtk every 20 objects outline\n"
        first = self.succeed(script(OBJECTS, DYNAMICS, output, "run 40\nwrite_restart mid.restart\nrun 60\n"), name="first")
        self.assertEqual(self.times(first), [0.0, 0.02, 0.04, 0.06, 0.08, 0.1])
        again = script(BOX, DYNAMICS, output, "run 20\n").splitlines()
        again = [line for line in again if not line.startswith(("region", "boundary"))]
        again = ["read_restart mid.restart" if line.startswith("create_box") else line for line in again]
        second = self.succeed("\n".join(again) + "\n", name="first")
        self.assertEqual(self.times(second), [0.0, 0.02, 0.04, 0.06])
        self.assertEqual(self.times(second, "all"), [0.0, 0.02, 0.04, 0.06])

    def test_a_run_from_a_restart_file_with_another_interval(self):
        """Frames between the restart file and the first one of the run that goes on are none of its own."""
        output = "fix out all output/vtk every {} objects outline\nfix measures all output/objects every {} file objects.csv\n"
        self.succeed(script(OBJECTS, DYNAMICS, output.format(20, 20), "restart 40 at.*\nrun 100\n"), name="first")
        again = script(BOX, DYNAMICS, output.format(70, 70), "run 60\n").splitlines()
        again = [line for line in again if not line.startswith(("region", "boundary"))]
        again = ["read_restart at.40" if line.startswith("create_box") else line for line in again]
        second = self.succeed("\n".join(again) + "\n", name="first", ranks=2)
        self.assertEqual(self.times(second), [0.0, 0.02, 0.04, 0.07])
        steps = [line.partition(",")[0] for line in (second.folder / "objects.csv").read_text().splitlines()]
        self.assertEqual(steps, ["step"] + [step for step in ("0", "20", "40", "70") for _ in range(3)])

    def test_frames_of_two_groups_go_into_two_folders(self):
        groups = "group big molecule 3\ngroup rest molecule 1 2\n"
        output = "fix a big output/vtk every 20 folder a objects outline\nfix b rest output/vtk every 10 folder b objects outline cds\n"
        result = self.succeed(script(OBJECTS, groups, DYNAMICS, output, "run 20\n"), ranks=2)
        self.assertEqual([len(frames.outlines(file)[0]) for _, file in self.frames(result, "outline", "a")], [1, 1])
        self.assertEqual([len(frames.outlines(file)[0]) for _, file in self.frames(result, "outline", "b")], [2, 2, 2])


class WhatFramesHold(FramesTest):
    def test_all_pieces_are_compressed(self):
        """Each rank's own; the water is at rest, so that there is almost nothing to tell."""
        water = WATER.replace("cells 16 16", "cells 128 128")
        output = "fix out all output/vtk every 10 fields velocity pressure objects outline points cds centres\n"
        result = self.succeed(script(CLOSED, OBJECTS.replace(BOX, "").replace("disk 0.01", "disk 0.11"), "fix hold all held\n", water, output, "run 0\n"), ranks=4)
        pieces = [file for file in (result.folder / "post").iterdir() if file.suffix in (".vti", ".vtp")]
        for piece in pieces:
            self.assertIn(b'compressor="vtkZLibDataCompressor"', piece.read_bytes()[:400], piece.name)
        fields = [piece for piece in pieces if piece.suffix == ".vti"]
        self.assertEqual(sorted(piece.name[-9:] for piece in fields), ["r0000.vti", "r0001.vti", "r0002.vti", "r0003.vti"])
        self.assertLess(sum(piece.stat().st_size for piece in fields), 0.1 * 128 * 128 * 4 * 8)

    def by_tag(self, result, name):
        positions, values = frames.vertices(self.frames(result, name)[-1][1])
        order = np.argsort(values["tag"])
        return positions[order], {key: array[order] for key, array in values.items()}

    def by_object(self, result):
        polygons, values = frames.outlines(self.frames(result, "outline")[-1][1])
        order = np.argsort(values["object_id"])
        return [polygons[i] for i in order], {key: array[order] for key, array in values.items()}

    def drift(self, ranks, processors):
        output = "fix out all output/vtk every 200 objects outline points cds\n"
        return self.succeed(script(OBJECTS, DRIFT, DYNAMICS, output, "run 200\n", processors=processors),
                            ranks=ranks, name=f"on_{ranks}")

    def test_objects_are_whole_and_right(self):
        polygons, values = self.by_object(self.drift(1, "* * 1"))
        self.assertEqual([len(polygon) for polygon in polygons], [12, 20, 24])
        np.testing.assert_allclose(values["natural_diameter"], [0.21, 0.11, 0.31], rtol=1e-12)
        np.testing.assert_allclose(values["velocity"][:, :2], [[-0.5, 0.1]] * 3, atol=1e-9)
        for polygon, diameter in zip(polygons, values["mean_diameter"]):
            self.assertAlmostEqual(max(np.ptp(polygon, axis=0)) / diameter, 1.0, places=2)

    def test_ranks_make_no_difference(self):
        one = self.drift(1, "* * 1")
        for ranks, processors in ((2, "2 1 1"), (2, "1 2 1"), (4, "2 2 1")):
            with self.subTest(processors=processors):
                several = self.drift(ranks, processors)
                self.assert_same_points(one, several)
                self.assert_same_outlines(one, several)
                shutil.rmtree(several.folder)

    def assert_same_points(self, one, several):
        for name in ("points", "cds"):
            (x, values), (other_x, others) = self.by_tag(one, name), self.by_tag(several, name)
            self.assertEqual(len(x), len(others["tag"]))
            # A hub near a periodic side may be shown on either side of the box.
            np.testing.assert_allclose((other_x - x)[:, 0] - np.round((other_x - x)[:, 0]), 0.0, atol=1e-12)
            np.testing.assert_allclose(other_x[:, 1], x[:, 1], atol=1e-12)
            for key in values:
                np.testing.assert_allclose(others[key], values[key], rtol=1e-9, atol=1e-9, err_msg=f"{name}: {key}")

    def assert_same_outlines(self, one, several):
        (_, values), (_, others) = self.by_object(one), self.by_object(several)
        for key in values:
            np.testing.assert_allclose(others[key], values[key], rtol=1e-9, atol=1e-9, err_msg=key)

    def test_fields_of_several_ranks_are_those_of_one(self):
        output = "fix out all output/vtk every 10 fields velocity pressure\n"
        water = WATER.rstrip() + " wall yhi velocity 0.1 0\n"
        grids = []
        for ranks in (1, 2, 4):
            result = self.succeed(script(CLOSED, OBJECTS.replace(BOX, ""), DYNAMICS, water, output, "run 20\n").replace("disk 0.01", "disk 0.11"),
                                  ranks=ranks, name=f"wet_{ranks}")
            self.assertEqual(self.times(result, "fields"), [0.0, 0.01, 0.02])
            grids.append(frames.fields(self.frames(result, "fields")[-1][1]))
        x, y, values = grids[0]
        np.testing.assert_allclose(x, (np.arange(16) + 0.5) / 16)
        self.assertEqual(values["velocity"].shape, (16, 16, 3))
        self.assertGreater(values["velocity"][-1, :, 0].mean(), 0.0)  # the lid is the upper side
        for _, _, others in grids[1:]:
            for name in values:
                np.testing.assert_allclose(others[name], values[name], atol=1e-10 * np.abs(values[name]).max(), err_msg=name)


class WhatAWrongLineSays(FramesTest):
    def refused(self, line, *words, before="", ranks=1):
        result = self.run_program(script(OBJECTS, DYNAMICS, before, line + "\nrun 5\n"), ranks=ranks)
        self.assertNotEqual(result.status, 0)
        for word in words:
            self.assertIn(word, result.output)
        self.assertEqual(result.output.count("ERROR:"), 1)

    def test_lines(self):
        out = "fix out all output/vtk "
        for line, words in (
                (out + "objects outline", ["every"]),
                (out + "every 0 objects outline", ["every", "0"]),
                (out + "every 10", ["nothing to write", "fields", "objects"]),
                (out + "every 10 objects outlines", ["outlines", "outline", "points", "cds"]),
                (out + "every 10 objects outline colour red", ["colour"]),
                (out + "every 10 fields velocity", ["fix fluid/ib"]),
                (out + "every 10 folder /dev/null/post objects cds", ["/dev/null/post", "keyword folder"]),
                (out + "every 10 objects cds\nfix two all output/vtk every 5 objects points", ["folder of its own", "fix out"])):
            for ranks in (1, 2):
                with self.subTest(line=line, ranks=ranks):
                    self.refused(line, *words, ranks=ranks)

    def test_fields_and_order(self):
        closed = script(CLOSED, OBJECTS.replace(BOX, "").replace("disk 0.01", "disk 0.11"), DYNAMICS)
        for lines, words in ((WATER + "fix out all output/vtk every 10 fields vorticity\n", ["'vorticity'", "velocity, pressure"]),
                             ("fix out all output/vtk every 10 fields velocity\n" + WATER, ["after fix fluid/ib"])):
            with self.subTest(lines=lines):
                result = self.run_program(closed + lines + "run 5\n", ranks=2)
                self.assertNotEqual(result.status, 0)
                for word in words:
                    self.assertIn(word, result.output)

    def test_a_folder_that_vanishes_ends_the_run(self):
        lines = "fix out all output/vtk every 20 objects outline\nrun 20\nshell mv post gone\nrun 20\n"
        for ranks in (1, 2):
            with self.subTest(ranks=ranks):
                result = self.run_program(script(OBJECTS, DYNAMICS, lines), ranks=ranks, name=f"on_{ranks}")
                self.assertNotEqual(result.status, 0)
                self.assertIn("cannot write 'post/outline_0000000040", result.output)
                self.assertEqual(self.times(result, folder="gone"), [0.0, 0.02])

    def test_objects_before_there_are_any(self):
        result = self.run_program(script(BOX, "fix out all output/vtk every 10 objects outline\nrun 5\n"))
        self.assertNotEqual(result.status, 0)
        self.assertIn("create_objects", result.output)


if __name__ == "__main__":
    unittest.main()
