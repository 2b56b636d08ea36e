"""How fast the disc turns, and the exact rate."""

import numpy as np

import caselib

SETTLED = 0.5  # of the time has passed when the mean rate over the rest is taken: the disc turns across cells in it


class Turning:
    def __init__(self, run):
        rows = caselib.read_csv(run.folder / "disc.csv")
        self.time, self.angle, self.spin, self.height, self.aspect_ratio = (
            np.array([row[name] for row in rows]) for name in ("time [s]", "rotation [rad]", "spin [rad/s]", "centroid_y [m]", "aspect_ratio"))
        self.settled = self.time >= SETTLED * self.time[-1]

    def rate(self):
        """Over the shear rate, positive with the shear."""
        time, angle = self.time[self.settled], self.angle[self.settled]
        return float(-(angle[-1] - angle[0]) / (time[-1] - time[0]))


def exact(run):
    """Where it is tabulated, else None."""
    return next((row["omega_over_gamma"] for row in run.reference if abs(row["k"] - run.variables["k"]) < 1e-4), None)
