"""The force between a disc and what it is pushed towards, that of fix lubrication/cds included, over the gap, and what is exact for it."""

import math

import numpy as np

import histories


class Approach:
    """By gap, in radii."""

    def __init__(self, run):
        self.run, self.history = run, histories.History(run)
        self.gap, self.added = self.history["gap"][::-1], self.history["added"][::-1]
        self.measured = self.history["force"][::-1] + self.added
        self.cells = run.variables["cells"]

    def force(self, gap):
        return float(np.interp(gap, self.gap, self.measured))

    def added_force(self, gap):
        """By fix lubrication/cds, part of the force."""
        return float(np.interp(gap, self.gap, self.added))

    def exact(self, gap):
        """Jeffrey & Onishi (1981) for a wall; for two discs what Reynolds' equation gives when the gap is small."""
        return to_wall(gap) if self.run.variables["with"] == "wall" else between_discs(gap)


def to_wall(gap):
    alpha = math.acosh(1.0 + gap)
    return 4.0 * math.pi / (alpha - math.tanh(alpha))


def between_discs(gap):
    return lubrication(gap, 0.5)


def lubrication(gap, radius):
    """Reynolds' equation in the gap of two parabolas, 1 / radius = 1 / R1 + 1 / R2: F = 3 sqrt(2) pi mu V (radius / gap)^1.5."""
    return 3.0 * math.sqrt(2.0) * math.pi * (radius / gap) ** 1.5
