"""Measures of objects as a file and as values: when lines are written, what they hold on one rank and on several, and that frames hold the same."""

import csv
import re
import unittest

import numpy as np

import frames
from program import ProgramTest
from scene import LINES, scene

# Twelve discs whose spheres press on each other's, across a periodic side too, and that turn and drift.
BED = {
    "boundary": "boundary p f p",
    "objects": "create_objects lattice 4 3 origin 0.02 0.25 spacing 0.25 disk diameter 0.2 points 16 density 1500 cds 0.2 type 1",
    "springs": "fix springs all mass_spring stiffness 1000 restitution 0.8",
    "move": "fix move all nve/cds\nfix weight all gravity 9.81 vector 0 -1 0\nfix flat all enforce2d\nvelocity all set 0.4 0.1 0 units box\n"
            "group fast molecule 6\nvelocity fast set 0.4 1 0 units box",
    "fluid": "", "thermo": "thermo 20",
}
MEASURES = "fix out all output/objects every 20 file measures/objects.csv"


def bed(output=MEASURES, **changes):
    return scene(**{**BED, "output": output, "run": "run 60", **changes})


def from_restart(script, file):
    """The same script, with its box and objects from a restart file."""
    gone = tuple(LINES[key].split()[0] for key in ("boundary", "region", "objects")) + ("velocity",)
    lines = [line for line in script.splitlines() if not line.startswith(gone)]
    return "\n".join("read_restart " + file if line.startswith("create_box") else line for line in lines) + "\n"


class Table:
    """{column without its unit: values} and {column: unit}, in the order of the file."""

    def __init__(self, file):
        with open(file, newline="") as source:
            header, *rows = csv.reader(source)
        found = [re.fullmatch(r"(\w+)(?: \[(.+)\])?", column).groups() for column in header]
        self.units = dict(found)
        self.columns = {name: np.array([float(row[k]) for row in rows]) for k, (name, _) in enumerate(found)}

    def __getitem__(self, name):
        return self.columns[name]

    def steps(self):
        return sorted(set(self["step"]))

    def at(self, step):
        chosen = self["step"] == step
        return {name: values[chosen] for name, values in self.columns.items()}


class ObjectsTest(ProgramTest):
    def table(self, result, file="measures/objects.csv"):
        return Table(result.folder / file)


class WhenLinesAreWritten(ObjectsTest):
    def test_a_second_run_neither_repeats_nor_skips(self):
        table = self.table(self.succeed(bed(run="run 30\nrun 10\nrun 25"), ranks=2))
        self.assertEqual(table.steps(), [0, 20, 40, 60])
        self.assertEqual(len(table["id"]), 4 * 12)
        np.testing.assert_allclose(table["time"], 1e-3 * table["step"], rtol=1e-12)

    def test_a_fix_that_is_made_anew_goes_on_in_the_same_file(self):
        table = self.table(self.succeed(bed(run=f"run 40\nunfix out\nrun 20\n{MEASURES}\nrun 20")))
        self.assertEqual(table.steps(), [0, 20, 40, 60, 80])

    def test_a_run_from_the_beginning_begins_a_new_file(self):
        self.succeed(bed())
        self.assertEqual(self.table(self.succeed(bed(run="run 20"))).steps(), [0, 20])

    def test_a_run_from_a_restart_file_replaces_later_lines_only(self):
        first = self.succeed(bed(run="run 40\nwrite_restart mid.restart\nrun 60"), name="first")
        before = self.table(first)
        self.assertEqual(before.steps(), [0, 20, 40, 60, 80, 100])
        with open(first.folder / "measures/objects.csv", "a") as file:
            file.write("120,0.12,1,0.5")  # half a line of a run that was killed
        for ranks in (1, 2):
            self.succeed(from_restart(bed(run="run 40"), "mid.restart"), name="first", ranks=ranks)
            after = self.table(first)
            self.assertEqual(after.steps(), [0, 20, 40, 60, 80])
            for step in after.steps():
                for name, values in after.at(step).items():
                    np.testing.assert_allclose(values, before.at(step)[name], rtol=1e-7, atol=1e-7, err_msg=f"{name} at {step}")


class MadeAnew(ObjectsTest):
    def test_objects_of_a_file_lie_where_they_were_measured(self):
        first = self.succeed(bed(), name="first")
        before = self.table(first).at(60)
        self.assertLess(before["area_ratio"].min(), 1 - 1e-6)
        for ranks in (1, 2):
            again = bed(MEASURES.replace("objects.csv", f"again_{ranks}.csv"), run="run 0",
                        objects="create_objects file measures/objects.csv points 16 density 1500 cds 0.2")
            after = self.table(self.succeed(again, name="first", ranks=ranks), f"measures/again_{ranks}.csv").at(0)
            for name in ("centroid_x", "centroid_y", "diameter_of_area"):
                np.testing.assert_allclose(after[name], before[name], rtol=1e-9, err_msg=name)
            np.testing.assert_allclose(after["area_ratio"], 1.0, rtol=1e-9)


class WhatLinesHold(ObjectsTest):
    def test_names_units_and_order(self):
        table = self.table(self.succeed(bed(), ranks=4))
        for step in table.steps():
            self.assertEqual(list(table.at(step)["id"]), list(range(1, 13)))
        for name, unit in {"time": "s", "centroid_x": "m", "velocity_y": "m/s", "rotation": "rad", "spin": "rad/s", "area": "m^2", "mass": "kg",
                           "spring_energy": "J", "net_contact_force_x": "N", "contact_pressure": "Pa", "coordination": None}.items():
            self.assertEqual(table.units[name], unit, name)

    def test_ranks_make_no_difference(self):
        one = self.table(self.succeed(bed(), name="on_1"))
        self.assertGreater(one["contact_pressure"].max(), 100.0)
        self.assertGreater(one["coordination"].max(), 2)
        self.assertGreater(np.abs(one["rotation"]).max(), 1e-6)
        for net in ("net_contact_force_x", "net_contact_force_y"):
            self.assertLess(abs(one[net].sum()), 1e-9 * one["contact_force"].sum())
        for ranks in (2, 4):
            other = self.table(self.succeed(bed(), name=f"on_{ranks}", ranks=ranks))
            for name, values in one.columns.items():
                difference = other[name] - values
                if name == "centroid_x":
                    difference -= np.round(difference)  # an object near a periodic side may be shown on either side of the box
                np.testing.assert_allclose(difference, 0.0, atol=1e-8 * (1.0 + np.abs(values).max()), err_msg=name)

    def test_frames_hold_the_same(self):
        output = MEASURES + "\nfix vtk all output/vtk every 20 objects outline centres"
        for ranks in (1, 2, 4):
            result = self.succeed(bed(output), name=f"vtk_{ranks}", ranks=ranks)
            table = self.table(result)
            series = list(frames.Series(result.folder / "post", "centres"))
            self.assertEqual([round(1000 * time) for time, _ in series], table.steps())
            for (_, file), step in zip(series, table.steps()):
                x, values = frames.vertices(file)
                order, line = np.argsort(values["object_id"]), table.at(step)
                np.testing.assert_array_equal(values["object_id"][order], line["id"])
                np.testing.assert_array_equal(x[order], np.transpose([line["centroid_x"], line["centroid_y"]]))
                self.assertEqual(set(line) - {"step", "time", "id", "centroid_x", "centroid_y"},
                                 {column for name in set(values) - {"object_id"} for column in ([name] if values[name].ndim == 1 else [name + "_x", name + "_y"])})
                for name in set(values) - {"object_id"}:
                    columns = [line[name]] if values[name].ndim == 1 else [line[name + "_x"], line[name + "_y"], 0.0 * line["id"]]
                    np.testing.assert_array_equal(values[name][order].T, np.squeeze(columns), err_msg=name)

    def test_values_are_those_of_the_lines(self):
        words = "thermo_style custom step " + " ".join(f"f_out[{n}]" for n in range(1, 19)) + "\nthermo 20"
        result = self.succeed(bed(thermo=words), ranks=2)
        for row in result.thermo():
            line = self.table(result).at(row["Step"])
            turned = np.abs(line["rotation"])
            expected = [12, line["mean_diameter"].mean(), line["diameter_of_area"].mean(), line["mean_diameter"].std(), line["area"].sum(),
                        line["aspect_ratio"].mean(), line["area_ratio"].min(), line["spring_energy"].sum(), line["kinetic_energy"].sum(),
                        line["contact_pressure"].mean(), line["contact_pressure"].max(), line["contact_force"].sum(), line["coordination"].mean(), turned.mean(),
                        turned.max(), line["velocity_x"].mean(), line["velocity_y"].mean(), line["centroid_y"].mean()]
            for n, value in enumerate(expected, 1):
                self.assertAlmostEqual(row[f"out[{n}]"], value, delta=1e-7 * (1.0 + abs(value)), msg=f"f_out[{n}] at {row['Step']}")

    def test_chosen_objects_and_no_file(self):
        words = "thermo_style custom step f_out f_sums f_one\nthermo 20"
        output = MEASURES + " objects 7 3\ngroup one molecule 5\nfix sums all output/objects every 20\nfix one one output/objects every 20 objects all"
        result = self.succeed(bed(output, thermo=words), ranks=2)
        self.assertEqual(list(self.table(result).at(40)["id"]), [3, 7])
        self.assertEqual([result.thermo()[-1][name] for name in ("out", "sums", "one")], [2, 12, 1])

    def test_neither_weight_nor_buoyancy_is_a_contact(self):
        """Apart from each other and the walls, in a fluid that moves them: what the fluid gives through LIGGGHTS' forces is known to the last digit."""
        wet = {"fluid": LINES["fluid"], "boundary": LINES["boundary"], "thermo": "", "objects": LINES["objects"]}
        for run in ("run 20", "run 7\nrun 13"):
            table = self.table(self.succeed(bed(MEASURES.replace("20", "1"), **wet, run=run), ranks=2))
            weight = 9.81 * table["mass"].max()
            self.assertGreater(weight, 100.0)
            self.assertLess(table["contact_force"].max(), 1e-9 * weight)
            self.assertLess(np.abs(table["contact_pressure"]).max(), 1e-9 * weight)
            self.assertEqual(table["coordination"].max(), 0)


if __name__ == "__main__":
    unittest.main()
