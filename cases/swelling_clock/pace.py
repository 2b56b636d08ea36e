"""What a run of this case gives: sizes and pressures by reading and object, and the measures of pace, from the columns of its files."""

import re

import numpy as np

import caselib
import histories

FLOW_BOUND, CONTACT_BOUND = 0.3, 0.02  # of docs/fix_swell.md


class Pace(caselib.Run):
    def __init__(self, folder):
        super().__init__(folder)
        self.history = histories.History(self)
        rows = caselib.read_csv(self.folder / "objects.csv")
        self.ids = len({row["id"] for row in rows})
        self.columns = {name.split(" [")[0]: np.array([row[name] for row in rows]).reshape(-1, self.ids) for name in rows[0]}
        self.is_bed = self.variables["scene"] == "bed"

    def __getitem__(self, name):
        return self.columns[name]

    def closing_speed(self):
        """dD/dt by the law, and by the load that is on each object."""
        largest = 0.3 if self.is_bed else 0.5
        free = self.variables["rate"] * self.variables["clock"] * (self["natural_diameter"] < largest)
        return free * np.clip(1.0 - self["contact_pressure"] / self.variables["load"], 0.0, 1.0) if self.is_bed else free

    def inertia_and_work(self):
        """By reading: the sums whose ratio is the inertial number squared."""
        natural_area = self["area"] / self["area_ratio"]
        w, p = self.closing_speed(), self["contact_pressure"]
        pressed = natural_area * w * (p > 0)
        return (pressed * self["mass"] / natural_area * w**2).sum(axis=1), (pressed * p).sum(axis=1)

    def against_contacts(self):
        inertia, work = self.inertia_and_work()
        return np.sqrt(np.divide(inertia, work, out=np.zeros_like(work), where=work > 0))

    def mean_against_contacts(self):
        """Over the area that the run has grown."""
        inertia, work = self.inertia_and_work()
        return float(np.sqrt(inertia.sum() / work.sum()))

    def against_flow(self, energy):
        D = self["natural_diameter"][:, 0]
        return self.closing_speed()[:, 0] / (self.variables["nu"] / D + np.sqrt(2.0 * energy))  # box and density are 1

    def mean(self, name):
        """Over the objects, by reading."""
        return self[name].mean(axis=1)

    def at_size(self, name, diameter):
        """The mean value when the mean natural diameter was this."""
        return float(np.interp(diameter, self.mean("natural_diameter"), self.mean(name)))

    def warning(self):
        """What fix swell said of the whole run, or none: (beside what, value)."""
        found = re.search(r"swelling was not slow beside (the flow|contacts): .* was (\S+),", (self.folder / "log.liggghts").read_text(errors="replace"))
        return (found.group(1), float(found.group(2))) if found else None
