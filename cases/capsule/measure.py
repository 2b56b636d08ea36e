"""Deformation, inclination and area of the capsule over time, and what is published of it."""

import math

import numpy as np

import ellipses


class Shapes:
    """By time in 1 / shear rate: Taylor's D and the angle in degrees of the ellipse with the capsule's second moments, and the area's relative error."""

    def __init__(self, run):
        frames = ellipses.of_run(run)
        self.time = [time * run.variables["shear"] for time, _ in frames]
        self.deformation = [shape.deformation for _, shape in frames]
        self.angle = [math.degrees(shape.angle) for _, shape in frames]
        self.area_errors = [shape.area / frames[0][1].area - 1 for _, shape in frames]

    def at(self, time, values):
        """Linear between two readings."""
        return float(np.interp(time, self.time, values))

    def largest_area_error(self):
        return max(map(abs, self.area_errors))


def published(run):
    """The table's rows for the run's Ca in the run's time, after the start, where all are circles; none for another Ca."""
    return [row for row in run.reference if row["Ca"] == run.variables["Ca"] and 0.0 < row["t"] <= run.variables["t_end"] + 1e-6]


def steady_deformation(run):
    return [row["D_inertia"] for row in run.reference if row["Ca"] == run.variables["Ca"]][-1]


class Comparison:
    """What a run has at the table's times, against the table: errors of D over the steady D, and of the angle in degrees."""

    def __init__(self, run, shapes):
        rows, steady = published(run), steady_deformation(run)
        self.time = [row["t"] for row in rows]
        self.deformation_errors = [(shapes.at(row["t"], shapes.deformation) - row["D_inertia"]) / steady for row in rows]
        self.angle_errors = [shapes.at(row["t"], shapes.angle) - row["theta_deg"] for row in rows]

    def largest_deformation_error(self):
        return max(map(abs, self.deformation_errors))

    def largest_angle_error(self):
        return max(map(abs, self.angle_errors))
