"""What a run of the case tells of its disc: how it moves, in units of U, and what velocity it comes to."""

from functools import cached_property

import numpy as np

import caselib
import histories

HEIGHT = 8.0  # of the box, which is periodic


class Motion(caselib.Run):
    @cached_property
    def history(self):
        return histories.History(self)

    @property
    def U(self):
        return self.variables["re"]

    @property
    def time(self):
        return self.history.time

    @cached_property
    def height(self):
        """Of the centre, without the jumps at the box's ends."""
        return np.unwrap(self.history["y"], period=HEIGHT)

    @property
    def down(self):
        """1 when it falls or is pulled, -1 when it rises."""
        return 1 if self.variables["density"] >= 1.0 else -1

    @cached_property
    def reported(self):
        """Velocities along weight or pull, over U, as the object's measures have them."""
        return -self.down * self.history["vy"] / self.U

    @cached_property
    def moved(self):
        """The same as the heights tell, between the readings."""
        return -self.down * np.diff(self.height) / np.diff(self.time) / self.U

    @cached_property
    def smooth(self):
        """The same in the mean of ten fluid steps, or of the steps between two readings."""
        window = max(1, round(10 / self.variables["reading"]))
        return np.convolve(self.moved, np.full(window, 1.0 / window), "valid")

    def late(self):
        """The readings in the last tenth of the time."""
        return self.history.since(0.9 * self.time[-1])

    @cached_property
    def terminal(self):
        """Mean velocity in the last tenth of the time, over U: by the way, so that the fluid's cells which the disc crosses count alike."""
        late = self.late()
        return -self.down * float(np.polyfit(self.time[late], self.height[late], 1)[0]) / self.U
