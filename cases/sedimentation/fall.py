"""What a run of the case tells of its fall: histories, greatest speed, when it meets the floor, how it rests there."""

from functools import cached_property

import numpy as np

import caselib
import histories

PAPER = {"A": {"diameter": 0.25, "growth": 0.0}, "B": {"diameter": 0.5, "growth": 0.0}, "C": {"diameter": 0.25, "growth": 0.25}}
COMMON = {"final": 0.5, "density": 1.25, "nu": 0.1, "gravity": 980.0}


class Fall(caselib.Run):
    @cached_property
    def history(self):
        return histories.History(self)

    @property
    def case_of_paper(self):
        """A, B or C, or none when a number of the scene is another."""
        for letter, sizes in PAPER.items():
            if all(self.variables[name] == value for name, value in {**COMMON, **sizes}.items()):
                return letter
        return None

    @property
    def cell(self):
        return 2.0 / self.variables["cells"]

    @property
    def time(self):
        return self.history.time

    @property
    def speed(self):
        """Downwards, of the centre of mass."""
        return -self.history["vy"]

    @cached_property
    def peak(self):
        return float(np.abs(self.speed).max())

    @property
    def gap(self):
        """Between the disc's lowest point and the floor."""
        return self.history["y"] - self.history["diameter"] / 2.0

    def at(self, name, times):
        return np.interp(times, self.time, self.history[name])

    @cached_property
    def landing(self):
        """The index of the reading from which on the disc is within a hundredth of its diameter of the floor, or the number of readings."""
        near = np.flatnonzero(self.gap < 0.01 * self.history["diameter"])
        return int(near[0]) if len(near) else len(self.time)

    @property
    def landed(self):
        """Time and diameter when it meets the floor, between the two readings, or none."""
        k = self.landing
        if not 0 < k < len(self.time):
            return None
        off = self.gap - 0.01 * self.history["diameter"]
        share = off[k - 1] / (off[k - 1] - off[k])
        return tuple(float(values[k - 1] + share * (values[k] - values[k - 1])) for values in (self.time, self.history["diameter"]))

    @cached_property
    def free(self):
        """The readings while it falls freely: as fast as a half of the greatest speed at least, and a diameter above the floor."""
        return (self.speed > 0.5 * self.peak) & (self.gap > self.history["diameter"])

    def speed_of_motion(self):
        """The speed that the heights tell: times and speeds between the readings, of the third order in their distance."""
        return (self.time[1:] + self.time[:-1]) / 2.0, -np.diff(self.history["y"]) / np.diff(self.time)

    def resting(self):
        """The readings of the last tenth of a unit of time."""
        return self.time > self.time[-1] - 0.1

    def depth_at_rest(self):
        """How far the outline may sink into the floor: the contact's spring under the weight in the fluid, and what the ring of points lacks to a circle."""
        variables = self.variables
        weight = abs(1.0 - 1.0 / variables["density"]) * variables["gravity"]
        corners = (1.0 - np.cos(np.pi / variables["points"])) * self.history["diameter"][-1] / 2.0
        return weight * (self.history["fluid_step"][-1] / variables["contact"]) ** 2 + corners
