"""The drag of a run of the square array: force of the discs along the mean velocity, and the force that drives the flow."""

import math

import histories


def along(run, history, x, y):
    angle = math.radians(run.variables["angle"])
    return history.last(x) * math.cos(angle) + history.last(y) * math.sin(angle)


def across(run, history, x, y):
    angle = math.radians(run.variables["angle"])
    return history.last(y) * math.cos(angle) - history.last(x) * math.sin(angle)


def drag(run):
    """F / (mu U) of one disc, as the discs feel it."""
    return along(run, histories.History(run), "drag", "lift") / run.variables["array"] ** 2


def drive(run):
    """The same, as the fluid is driven: force per volume times L^2 = 1."""
    return along(run, histories.History(run), "drive_x", "drive_y")


def permeability(run, drag):
    """Darcy's, over the square of the diameter: mu U L^2 / F = 1 / F, and D^2 = 4 phi / pi."""
    return math.pi / (4 * run.variables["phi"] * drag)


def published(run):
    return next((row["exact"] for row in run.reference if row["phi"] == run.variables["phi"]), None)
