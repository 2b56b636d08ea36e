"""What a disc does to a stream, for the cases that hold one: coefficients, the wake, the pressure on its front and back."""

import numpy as np

import fields

OUTSIDE = (2.5, 3.5, 4.5, 5.5)  # cells from the outline: the delta kernel still bends the pressure 1.5 cells outside


def coefficient(force, velocity, diameter, density=1.0):
    return 2.0 * force / (density * velocity**2 * diameter)


def wake_length(frame, centre, diameter):
    """Length of the recirculation behind the disc, from its back to where the velocity on its axis turns; None without one."""
    back = centre[0] + diameter / 2
    x = back + np.arange(2.0 * frame.h, frame.x[-1] - back, frame.h / 4)
    u = frame.at("u", x, centre[1])
    end = fields.crossing(x, u)
    return None if end is None or u[0] >= 0 else end - back


def surface_pressure(frame, centre, diameter, side):
    """Pressure on the disc's axis at its front (side -1) or back (side 1). The kernel smears the jump on the outline, so the value
    is that of the cubic through four points outside: a parabola would be off by half a per cent with 40 cells across the disc."""
    outside = np.array(OUTSIDE) * frame.h
    pressure = frame.at("pressure", centre[0] + side * (diameter / 2 + outside), centre[1])
    return np.polynomial.Polynomial.fit(outside, pressure, 3)(0.0)
