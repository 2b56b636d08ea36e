"""A field of the fluid between the centres of its cells: at points and along lines, of the fourth order.

    last = fields.last(run)
    p = last.at("pressure", 0.15, 0.2)
    place, value = fields.extremum(last.y, last.at("u", 0.5, last.y), -1)
"""

import numpy as np

import frames


class Frame:
    """One frame: its time, cell centres x and y, cell size h, and the values u, v, pressure and those of scalars by their names."""

    def __init__(self, time, file):
        self.time = time
        self.x, self.y, values = frames.fields(file)
        self.h = self.x[1] - self.x[0]
        velocity = values.pop("velocity")
        self.values = {"u": velocity[..., 0], "v": velocity[..., 1], **values}

    def at(self, name, x, y):
        """Values at points; x and y are numbers or arrays."""
        x, y = np.broadcast_arrays(np.asarray(x, float), np.asarray(y, float))
        first_x, weights_x = cubic(self.x, x)
        first_y, weights_y = cubic(self.y, y)
        return sum(weights_y[j] * weights_x[i] * self.values[name][first_y + j, first_x + i] for j in range(4) for i in range(4))

    def finite(self):
        return all(np.isfinite(values).all() for values in self.values.values())


def series(run):
    """All frames of a run in order of time."""
    return (Frame(time, file) for time, file in frames.Series(run.folder / "post", "fields"))


def last(run):
    return Frame(*frames.Series(run.folder / "post", "fields").frames[-1])


def cubic(centres, x):
    """First of the four cells about each x, moved inwards at an end, and the weights of Lagrange's cubic through them."""
    h = centres[1] - centres[0]
    first = np.clip(np.floor((x - centres[0]) / h).astype(int) - 1, 0, len(centres) - 4)
    s = (x - centres[0]) / h - first
    return first, [np.prod([(s - k) / (j - k) for k in range(4) if k != j], axis=0) for j in range(4)]


def extremum(x, values, sign):
    """Place and value of the largest (sign 1) or the smallest (sign -1) value: of the quartic through the five points about it."""
    middle = int(np.clip(np.argmax(sign * values), 2, len(x) - 3))
    scale = x[1] - x[0]
    quartic = np.polynomial.Polynomial.fit((x[middle - 2:middle + 3] - x[middle]) / scale, values[middle - 2:middle + 3], 4, domain=[-2, 2])
    fine = np.linspace(-2, 2, 4001)
    best = fine[np.argmax(sign * quartic(fine))]
    return x[middle] + scale * best, quartic(best)


def crossing(x, values):
    """The first place where the values turn from negative to positive (linear between two points), or None."""
    turns = np.flatnonzero((values[:-1] < 0) & (values[1:] >= 0))
    if not len(turns):
        return None
    i = turns[0]
    return x[i] - values[i] * (x[i + 1] - x[i]) / (values[i + 1] - values[i])
