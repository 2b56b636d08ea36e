"""What a run of the case wrote of its bead: hours, diameters in mm, rotation."""

import caselib


class Bead(caselib.Run):
    @property
    def rows(self):
        return [{name.split()[0]: value for name, value in row.items()} for row in caselib.read_csv(self.folder / "bead.csv")]

    def grown(self):
        """(time in s, diameter in mm) of all readings after the start, where the bead has its 3 mm."""
        return [(row["time"], 1e3 * row["mean_diameter"]) for row in self.rows if row["time"] > 0.0]

    def at(self, hours):
        """Diameter in mm, or none when the run has no reading then."""
        return next((diameter for time, diameter in self.grown() if abs(time - 3600.0 * hours) < 1e-6 * time), None)
