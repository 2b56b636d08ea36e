"""The bed over time and over height, from history.csv and objects.csv: solid fraction, permeability, and the layers of beads as they were made."""

import csv
import math

import numpy as np

import caselib
import frames
from histories import History

SETTLED = (0.15, 0.2)  # shares of the run between which the bed has packed under the flow and little has swollen
END = (0.9, 1.0)
LAYERS = ("lower", "middle", "upper")  # thirds of the beads, by the height at which they were made
LAYER_VALUES = {"swelling_ratio": "natural swelling ratio", "contact_pressure [Pa]": "contact pressure [Pa]", "aspect_ratio": "aspect ratio",
                "diameter_of_area [m]": "diameter [m]", "uptake [m^2]": "uptake [m^2]", "concentration": "concentration", "area_ratio": "area over natural area"}


def chord_area(radius, height):
    """Area of a disc below a line that is `height` above its centre."""
    s = np.clip(height / radius, -1.0, 1.0)
    return radius**2 * (math.pi / 2 + np.arcsin(s) + s * np.sqrt(1.0 - s**2))


def within(times, begin, end):
    share = times / times[-1]
    return (share > begin) & (share <= end + 1e-9)


def inside(polygon, points):
    """Which of the points lie in a polygon: those from which a ray crosses its sides an odd number of times."""
    a, b = polygon, np.roll(polygon, -1, axis=0)
    x, y = points[:, :1], points[:, 1:]
    spans = (a[:, 1] > y) != (b[:, 1] > y)
    with np.errstate(divide="ignore", invalid="ignore"):
        crossing = a[:, 0] + (y - a[:, 1]) * (b[:, 0] - a[:, 0]) / (b[:, 1] - a[:, 1])
    return (spans & (x < crossing)).sum(axis=1) % 2 == 1


class Bed:
    """times: those of objects.csv; value("area [m^2]"): by time and bead, in the order of their ids."""

    def __init__(self, run):
        self.run, self.history = run, History(run)
        v = run.variables
        self.width = v["across"] * v["diameter"]
        rows = caselib.read_csv(run.folder / "objects.csv")
        self.columns = {name: np.array([row[name] for row in rows]) for name in rows[0]}
        self.beads = len({row["id"] for row in rows})
        self.times = self.value("time [s]")[:, 0]
        heights = self.value("centroid_y [m]")
        self.layer = np.argsort(np.argsort(heights[0])) * len(LAYERS) // self.beads
        self.radius = np.sqrt(self.value("area [m^2]") / math.pi)
        self.top, self.bottom = (heights + self.radius).max(axis=1), (heights - self.radius).min(axis=1)
        made = caselib.read_csv(run.folder / "bed.csv")[0]
        self.head, self.grids = made["head"], (made["lower_grid"], made["upper_grid"])

    def escaped(self):
        """Beads that are not between the grids at the end."""
        y = self.value("centroid_y [m]")[-1]
        return int(((y < self.grids[0]) | (y > self.grids[1])).sum())

    def entangled(self):
        """Pairs of outlines in the last frame of which one has points within the other: contacts that were pressed through."""
        polygons, _ = frames.outlines(frames.Series(self.run.folder / "post", "outline").nearest(self.times[-1])[1])
        middles = np.array([polygon.mean(axis=0) for polygon in polygons])
        radii = np.array([np.hypot(*(polygon - middle).T).max() for polygon, middle in zip(polygons, middles)])
        pairs = set()
        for k, polygon in enumerate(polygons):
            near = np.flatnonzero(np.hypot(*(middles - middles[k]).T) < radii + radii[k])
            pairs |= {frozenset((k, j)) for j in near if j != k and inside(polygon, polygons[j]).any()}
        return len(pairs)

    def value(self, name):
        return self.columns[name].reshape(-1, self.beads)

    def in_layer(self, name, k, of=np.mean):
        return of(self.value(name)[:, self.layer == k], axis=1)

    def solid_below(self, frame, height):
        """Area of the beads below a height; each as a disc of its area."""
        return float(chord_area(self.radius[frame], height - self.value("centroid_y [m]")[frame]).sum())

    def porosity(self, frame, low, high):
        return 1.0 - (self.solid_below(frame, high) - self.solid_below(frame, low)) / (self.width * (high - low))

    def porosity_of_parts(self, frame, parts):
        """Of as many parts of equal height between the beads' lowest and highest points: middles and values."""
        edges = np.linspace(self.bottom[frame], self.top[frame], parts + 1)
        return 0.5 * (edges[1:] + edges[:-1]), np.array([self.porosity(frame, a, b) for a, b in zip(edges[:-1], edges[1:])])

    def flow(self, time):
        """Superficial velocity, mean over the interval about a time."""
        return float(np.interp(time, self.history.time, self.history["superficial_velocity"]))

    def frames(self, begin, end):
        """Those between two shares of the run, as means over them are taken: single values tremble as beads shift."""
        return np.flatnonzero(within(self.times, begin, end))

    def mean_flow(self, begin, end):
        return float(self.history["superficial_velocity"][within(self.history.time, begin, end)].mean())

    def choking(self):
        """Mean flow at the end over that of the settled bed."""
        return self.mean_flow(*END) / self.mean_flow(*SETTLED)

    def mean_permeability(self, begin, end):
        return float(np.mean([self.permeability(k) for k in self.frames(begin, end)]))

    def permeability(self, frame):
        """Darcy: mu U L / head, L the height of the bed; the grids and the free water take next to nothing of the head."""
        return self.run.variables["viscosity"] * self.flow(self.times[frame]) * (self.top[frame] - self.bottom[frame]) / self.head

    def write_layers(self, path):
        """One line a time and layer."""
        with open(path, "w", newline="") as file:
            out = csv.writer(file)
            out.writerow(["time [s]", "layer", "superficial velocity [m/s]", "permeability [m^2]", "porosity of the bed", "spread of diameters", *LAYER_VALUES.values()])
            for frame, time in enumerate(self.times):
                whole = [self.flow(time), self.permeability(frame), self.porosity(frame, self.bottom[frame], self.top[frame])]
                for k, name in enumerate(LAYERS):
                    spread = self.in_layer("diameter_of_area [m]", k, np.std)[frame] / self.in_layer("diameter_of_area [m]", k)[frame]
                    values = [self.in_layer(column, k, np.sum if column.startswith("uptake") else np.mean)[frame] for column in LAYER_VALUES]
                    out.writerow([f"{time:g}", name, *(f"{value:.6g}" for value in (*whole, spread, *values))])
