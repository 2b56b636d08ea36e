"""The permeability of a run of the random array, and what it can be held against. Lengths in D."""

import math

import numpy as np

import caselib
import exact
import histories


def permeability(run):
    """Darcy's k / D^2 along and across the drive: superficial velocity over the fall of pressure per length."""
    history = histories.History(run)
    return history.last("mean_x") / history.last("drive"), history.last("mean_y") / history.last("drive")


def side(run):
    """Of the box."""
    return math.sqrt(math.pi * run.variables["discs"] / (4 * run.variables["phi"]))


def cells(run):
    """Across a disc, as many as make the box a whole number."""
    return round(side(run) * run.variables["cells"]) / side(run)


def places(run):
    """Where the discs are, as the run wrote it."""
    rows = [{title.split(" ")[0]: value for title, value in row.items()} for row in caselib.read_csv(run.folder / "objects.csv")]
    return np.array([[row["centroid_x"], row["centroid_y"]] for row in rows if row["step"] == rows[0]["step"]])


def exact_permeability(run):
    """Of discs at these very places, along and across the drive: to 1e-5 when the points on a rim are no farther apart than two thirds of the gap."""
    points = 2 * math.ceil(0.5 * max(48.0, 1.5 * math.pi / max(run.variables["gap"], 0.03)))
    tensor = exact.permeability(places(run), 0.5, side(run), points)
    return tensor[0, 0], tensor[1, 0]


def kozeny_constant(phi, k):
    """k = (1 - phi)^3 / (K phi^2 S^2) with the surface per volume of discs, S = 4 / D (Carman 1937)."""
    return (1 - phi) ** 3 / (16 * phi**2 * k)


def happel(phi):
    """k / D^2 of a cell without shear on its rim, flow across a cylinder: Happel, AIChE J. 5, 174 (1959)."""
    return (-math.log(phi) - (1 - phi**2) / (1 + phi**2)) / (32 * phi)


def kuwabara(phi):
    """The same of a cell without vorticity on its rim: Kuwabara, J. Phys. Soc. Jpn 14, 527 (1959)."""
    return (-math.log(phi) - 1.5 + 2 * phi - 0.5 * phi**2) / (32 * phi)


def square(reference, phi):
    """The same of the square array, from reference.csv; None for other fractions."""
    return next((row["square"] for row in reference if row["phi"] == phi), None)
