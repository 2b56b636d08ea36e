"""Exact velocities between two plates, over the velocity U in the middle (couette: of the plate; film: of the free surface)."""

import numpy as np

TRANSIENT = ("pressure", "force", "couette", "film")  # for which the flow from rest is known in closed form
TERMS = 400


def steady(row, s):
    """`row` of reference.csv, s from plate to plate."""
    return row["c1"] * s + row["c2"] * s**2


def deviation(flow, s, t):
    """What is to be added to the steady profile at the time t = nu time / H^2 after the start (Batchelor 1967, section 4.3): a
    Fourier series."""
    if flow == "film":  # the lower half of a channel of twice the height
        return deviation("pressure", s / 2, t / 4)
    n = np.arange(1, TERMS) if flow == "couette" else np.arange(1, TERMS, 2)
    size = 2 * (-1.0) ** n / (n * np.pi) if flow == "couette" else -32 / (n * np.pi) ** 3
    return (size * np.exp(-(n * np.pi) ** 2 * t) * np.sin(np.pi * np.outer(s, n))).sum(axis=1)


def profile(frame, run):
    """s and the velocity over U halfway along the box."""
    half = run.variables["length"] / 2
    if run.variables["along"] == "x":
        return frame.y, frame.at("u", half, frame.y) / run.variables["u"]
    return frame.x, frame.at("v", frame.x, half) / run.variables["u"]
