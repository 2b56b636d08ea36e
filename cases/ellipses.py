"""The ellipse with the area's second moments of a polygon, and how it changes over a run.

    for time, ellipse in ellipses.of_run(run):      the one object of the run, in each frame of the folder `shape`
        ellipse.long, ellipse.short, ellipse.angle, ellipse.area
"""

import math
from dataclasses import dataclass

import numpy as np

import frames


@dataclass
class Ellipse:
    area: float    # of the polygon
    x: float       # centroid
    y: float
    long: float    # semi-axes: those of a polygon with its corners on an ellipse are those of the ellipse but for the part that the sides cut off
    short: float
    angle: float   # of the long axis from the x axis, in radians, from -pi/2 to pi/2

    @property
    def deformation(self):
        """Taylor's D."""
        return (self.long - self.short) / (self.long + self.short)


def of_polygon(corners):
    x, y = (corners - corners.mean(axis=0)).T
    x1, y1 = np.roll(x, -1), np.roll(y, -1)
    cross = x * y1 - x1 * y
    area = cross.sum() / 2
    cx, cy = ((x + x1) * cross).sum() / (6 * area), ((y + y1) * cross).sum() / (6 * area)
    xx = ((x * x + x * x1 + x1 * x1) * cross).sum() / (12 * area) - cx * cx
    yy = ((y * y + y * y1 + y1 * y1) * cross).sum() / (12 * area) - cy * cy
    xy = ((2 * x * y + x * y1 + x1 * y + 2 * x1 * y1) * cross).sum() / (24 * area) - cx * cy
    mean, half = (xx + yy) / 2, math.hypot((xx - yy) / 2, xy)
    middle = corners.mean(axis=0)
    return Ellipse(area, middle[0] + cx, middle[1] + cy, 2 * math.sqrt(mean + half), 2 * math.sqrt(mean - half), math.atan2(2 * xy, xx - yy) / 2)


def of_run(run):
    """Pairs of time and ellipse."""
    return [(time, of_polygon(frames.outlines(file)[0][0])) for time, file in frames.Series(run.folder / "shape", "outline")]


def inscribed(corners):
    """Area of the regular polygon with so many corners over that of its circle."""
    return math.sin(2 * math.pi / corners) * corners / (2 * math.pi)
