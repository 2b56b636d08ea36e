"""The path of the disc across the channel, and the published one."""

import numpy as np

import caselib

PUBLISHED = {"k": 0.25, "re": 40.0, "start": 0.25}  # what the table holds for; it is of a disc of the fluid's density


class Path:
    """time in H / U, height over H, rotation [rad] and spin over U / H, at all readings."""

    def __init__(self, run):
        rows = caselib.read_csv(run.folder / "disc.csv")
        self.time, self.height, self.rotation, self.spin, self.area_ratio = (
            np.array([row[name] for row in rows]) for name in ("time [s]", "centroid_y [m]", "rotation [rad]", "spin [rad/s]", "area_ratio"))
        self.table = np.array([(row["t"], row["y_over_H"]) for row in run.reference if row["t"] <= self.time[-1]]).T

    def deviations(self):
        """Height less the published one, over H, at the table's times."""
        time, height = self.table
        return np.interp(time, self.time, self.height) - height


def is_published(run):
    return all(run.variables[name] == value for name, value in PUBLISHED.items())
