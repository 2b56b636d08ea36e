"""The elastic ring in unbounded creeping flow, in closed form.

The ring is X(theta) = (a cos theta, b sin theta), F = kappa d2X/dtheta2 d theta. With A = (a + b) / 2 and B = (a - b) / 2 the force on the circle falls into the mode
n = 2 of the shape, which decays at n kappa / (4 mu), and a pressure: B = B_0 exp(-kappa t / (2 mu)), and the area keeps A^2 - B^2 = a b.
"""

import math


def semi_axes(long, short, time):
    """a and b after `time` in mu / kappa."""
    b = (long - short) / 2 * math.exp(-time / 2)
    a = math.sqrt(long * short + b * b)
    return a + b, a - b
