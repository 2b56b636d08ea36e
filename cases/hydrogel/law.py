"""Eq. (6) of the paper: the diameter in mm over the time in s, until 9.7 hours; coefficient k belongs to t^k."""

COEFFICIENTS = {"printed": (2.98, 0.002, -1.85e-7, 1.04e-11, -3.36e-16, 5.88e-21, -4.38e-26),
                "reconstructed": (2.97764, 1.86646e-3, -1.84764e-7, 1.04236e-11, -3.35764e-16, 5.88236e-21, -4.37764e-26)}
LAST = 34920.0


def diameter(form, time):
    time, value = min(time, LAST), 0.0
    for coefficient in reversed(COEFFICIENTS[form]):
        value = value * time + coefficient
    return value
