"""How the dye has spread, and how it should have. Times in H^2 / D, lengths in H; variances are those of its amount along the channel."""

import numpy as np

import fields

TERMS = 200


def rate(pe):
    """The dispersion coefficient over D, once diffusion has mixed the dye across: Wooding (1960)."""
    return 1 + pe**2 / 210


def variance(pe, t):
    """Growth of the variance of dye that begins even across the channel. Its moments obey closed equations (Aris 1956); with the flow as a series, 6 s (1 - s) = 1 - sum of
    6 / (pi n)^2 cos(2 pi n s), each term makes a distribution across that diffusion takes away at the rate (2 pi n)^2."""
    n = np.arange(1, TERMS)
    decay, strength = (2 * np.pi * n) ** 2, 18 * pe**2 / (np.pi * n) ** 4
    late = -np.expm1(-np.outer(np.atleast_1d(t), decay))
    return 2 * rate(pe) * np.asarray(t) - 2 * (strength / decay**2 * late).sum(axis=1)


class Spread:
    """Of a run, an entry a frame: t, by how much the dye is off the place where the mean velocity would have taken it, its variance."""

    def __init__(self, run):
        series, pe, along = list(fields.series(run)), run.variables["pe"], run.variables["along"]
        self.pe = pe
        self.t = np.array([frame.time - series[0].time for frame in series]) / pe
        self.off, self.variance = np.array([moments(frame, along, pe * t) for frame, t in zip(series, self.t)]).T

    def exact(self):
        return self.variance[0] + variance(self.pe, self.t)

    def error(self):
        """Of the variance, the largest in all frames, relative."""
        return float(abs(self.variance / self.exact() - 1).max())

    def off_course(self):
        return float((abs(self.off) / np.sqrt(self.exact())).max())

    def rate(self):
        """Half of that at which the variance grows in the second half of the time."""
        late = self.t >= 0.5 * self.t[-1] - 1e-9
        return 0.5 * np.polyfit(self.t[late], self.variance[late], 1)[0]


def moments(frame, along, way):
    """The channel is periodic: places are counted from where the mean should be."""
    place = frame.x if along == "x" else frame.y
    amount = frame.values["dye"].sum(axis=0 if along == "x" else 1)
    length = frame.h * len(place)
    away = (place - way) % length - 0.5 * length  # the dye began in the middle
    mean = (amount * away).sum() / amount.sum()
    return mean, (amount * (away - mean) ** 2).sum() / amount.sum()
