"""The axes along which the scene goes to extremes, its points along each of them and in pairs, and the variables of the script that a point is."""

import functools
import itertools
import math
from dataclasses import dataclass, field

import numpy as np

import study

BASE = {"density": 1.5, "ks": 1e3, "kn": 1e4, "re": 20, "across": 12, "points": 40, "step": 0.3, "spring_step": 0.5, "contact_step": 0.3, "ratio": 1.3, "growth": 0.2, "fill": 0.2}
AXES = {  # from one extreme to the other
    "density": (0.01, 0.1, 0.5, 0.9, 1, 1.1, 10, 100, 1000),                 # of the discs over that of the fluid
    "ks": (1, 10, 100, 1e4, 1e5, 1e6, 1e8, 1e10),                            # spring constant over density of the fluid x U^2
    "kn": (10, 100, 1e3, 1e5, 1e6, 1e7),                                     # stiffness of contact over the same
    "re": (0.01, 0.1, 1, 100, 1000, 5000),                                   # U D / nu
    "across": (4, 6, 8, 24, 50),                                             # cells across a disc
    "points": (8, 12, 20, 80, 200),                                          # on a ring
    "step": (0.1, 0.6, 1, 2, 4, 10),                                         # fluid step over that in which U crosses a cell
    "spring_step": (0.1, 0.9, 0.99, 1.01, 2, 10),                            # DEM step over the longest with which springs are stable
    "contact_step": (0.1, 0.6, 1, 2, 4, 10),                                 # DEM step over the longest with which two points in contact are stable
    "ratio": (0.5, 0.8, 2, 4, 10),                                           # of the natural diameter at the end of the swelling law
    "growth": (1e-3, 1e-2, 0.05, 0.5, 1),                                    # of a radius, cells in a fluid step
    "fill": (0.05, 0.4, 0.6, 0.7, 0.75, 0.8, 0.85, 0.9, 0.95),               # share of the box that the discs' largest natural size is
}
INTEGRATORS = {"explicit": "nve/cds", "implicit": "nve/cds implicit", "rigid": "rigid/cds"}
UNKNOWN = {"explicit": (), "implicit": ("spring_step",), "rigid": ("spring_step", "ks")}  # axes that mean nothing to an integrator
DRIVES = {"weight": (), "stream": ("ratio", "growth", "fill")}                            # and in a scene
SHORT = (("weight", "explicit", {}), ("weight", "rigid", {"density": 0.01, "re": 5000}), ("weight", "implicit", {"ks": 1e10, "points": 8}),
         ("weight", "explicit", {"spring_step": 10}), ("weight", "rigid", {"fill": 0.95}), ("weight", "implicit", {"ratio": 0.5, "growth": 1}),
         ("stream", "explicit", {"density": 1000, "kn": 10}), ("weight", "rigid", {"across": 50, "step": 10}), ("stream", "explicit", {}),
         ("stream", "rigid", {"density": 1000, "re": 0.01}), ("stream", "implicit", {"density": 0.01, "re": 5000}), ("stream", "explicit", {"kn": 10, "points": 200}))

RING = 0.4                 # radius of the ring of mass points: the outline less a contact detection sphere
SUB_STEPS, STEPS = 300, 100 # most DEM steps in a fluid step, least fluid steps
CELL_STEPS, DEM_STEPS = 3e7, 4e4  # what a point may cost
SETTLING = 30              # fluid steps after the swelling law has ended
FAXEN = ((0.05, 6.028936), (0.1, 8.950604), (0.2, 16.532547), (0.25, 21.963553), (0.5, 99.367608))  # exact drag on a disc between plates, cases/stokes_channel


@dataclass
class Scene:
    """What a setting of the axes makes of the scene; lengths in D, velocities in U, the fluid's density is 1."""
    drive: str
    motion: str              # a key of INTEGRATORS
    changes: dict            # of BASE
    setting: dict = field(init=False)

    def __post_init__(self):
        self.setting = {**BASE, **self.changes}
        self.cell = 1.0 / self.setting["across"]
        self.find_size()
        self.find_steps()

    def __getattr__(self, name):
        return self.setting[name]

    @property
    def name(self):
        words = [f"{key}{value:g}" for key, value in self.changes.items()] or ["base"]
        return "_".join([self.drive, self.motion, *words])

    # the box, whole cells wide, and the size that fills it as is wanted

    def find_size(self):
        if self.drive == "stream":
            self.width, self.setting["ratio"] = 3.0, 1.0
            return
        largest = max(1.0, self.ratio)
        self.width = self.cell * round(largest * math.sqrt(math.pi / (4 * self.fill)) / self.cell)
        if self.ratio > 1.0:
            self.setting["ratio"] = self.width * math.sqrt(4 * self.fill / math.pi)

    # steps: the fluid's by U and the cell, DEM's by springs and contacts

    @property
    def mass(self):
        return self.density * math.pi / 4

    @property
    def point_mass(self):
        return self.mass * point_share(self.points)

    def spring_limit(self):
        """2 / the highest frequency of a disc."""
        return 2.0 / math.sqrt(self.ks * stiffest_mode(self.points) / self.mass)

    def breathing_frequency(self):
        """With which a disc's size swings about the natural one: omega^2 = sum of k L^2 / sum of m r^2."""
        return math.sqrt(self.points * self.ks * (1 + 4 * math.sin(math.pi / self.points) ** 2) / (self.mass * self.points * point_share(self.points)))

    def contact_limit(self):
        """Of two points; of two rigid discs that meet at ten of their points."""
        return 2.0 * math.sqrt(0.5 * self.contact_mass() / self.kn)

    def contact_mass(self):
        return self.mass / 10 if self.motion == "rigid" else self.point_mass

    def wanted_dem_step(self):
        """The shorter of what springs and contacts ask for.

        Where an axis goes beyond the one limit, the other is moved out of the way, or to where its own axis has it, by its stiffness.
        """
        if self.motion == "explicit" and "spring_step" in self.changes:
            dt = self.spring_step * self.spring_limit()
            if "kn" not in self.changes:
                self.setting["kn"] = 2.0 * self.contact_mass() * (self.contact_step / dt) ** 2
            return dt
        of_contacts = self.contact_step * self.contact_limit()
        if self.motion != "explicit":
            return of_contacts
        if "contact_step" in self.changes:
            if "ks" not in self.changes:
                self.setting["ks"] *= (self.spring_step * self.spring_limit() / of_contacts) ** 2
            return of_contacts
        return min(of_contacts, self.spring_step * self.spring_limit())

    def find_steps(self):
        fluid_step, wanted = self.step * self.cell, self.wanted_dem_step()
        self.every = min(SUB_STEPS, max(1, math.ceil(fluid_step / wanted - 1e-9)))
        exact = "spring_step" in self.changes or "contact_step" in self.changes or self.every == SUB_STEPS
        self.dt = wanted if exact else fluid_step / self.every
        growing = abs(self.ratio - 1.0) / 2 / (self.growth * self.cell)
        cells = 2 * (self.width / self.cell) ** 2
        affordable = min(CELL_STEPS / cells, DEM_STEPS / self.every)
        self.fluid_steps = int(max(STEPS, min(growing + SETTLING, affordable)))

    @property
    def fluid_step(self):
        return self.every * self.dt

    @property
    def rate(self):
        """Of the natural diameter."""
        return 0.0 if self.drive == "stream" else math.copysign(2 * self.growth * self.cell / self.fluid_step, self.ratio - 1.0)

    # the drag at U is what a disc weighs in the fluid; with the fluid's density it is as heavy as if it had twice that

    def creeping_drag(self):
        """Over viscosity x velocity, between plates.

        Beyond what is tabulated that of the widest: true drag is larger, in a closed box too (the least dissipation is that of the least bounded).
        """
        widths, drags = zip(*FAXEN)
        return math.exp(np.interp(math.log(1.0 / self.width), np.log(widths), np.log(drags)))

    @property
    def gravity(self):
        return (self.creeping_drag() / self.re + 0.75) / (math.pi / 4 * (abs(self.density - 1.0) or 1.0))

    def variables(self):
        variables = {"drive": self.drive, "integrator": INTEGRATORS[self.motion], "gravity": self.gravity, "rate": self.rate, "end": "min" if self.rate < 0 else "max",
                     "width": self.width, "dt": self.dt, "every": self.every, "fluid_steps": self.fluid_steps,
                     **{key: self.setting[key] for key in ("density", "re", "ks", "kn", "across", "points", "ratio")}}
        return {key: f"{value:.12g}" if isinstance(value, float) else value for key, value in variables.items()}

    def point(self):
        return study.Point(self.name, "extremes/scene", self.variables(), labels={"drive": self.drive, "motion": self.motion, **self.changes_in_words()},
                           weight=1.0 + self.fluid_steps * (self.width / self.cell) ** 2 / 1e6, timeout=120)

    def changes_in_words(self):
        """Two columns of the table: what was changed."""
        words = [f"{key}={value:g}" for key, value in self.changes.items()] + ["", ""]
        return {"first": words[0], "second": words[1]}


def point_share(n):
    """Of the mass: the ring has the disc's moment of inertia, 1/8."""
    return 1.0 / (8 * RING**2 * n)


@functools.cache
def stiffest_mode(n):
    """Largest eigenvalue of M^-1 K for springs of stiffness 1 between neighbours of a ring and from each of its n points to the hub, of mass 1 in all."""
    place = [RING * np.array([math.cos(2 * math.pi * k / n), math.sin(2 * math.pi * k / n)]) for k in range(n)] + [np.zeros(2)]
    stiffness = np.zeros((2 * n + 2, 2 * n + 2))
    for a, b in [(k, (k + 1) % n) for k in range(n)] + [(k, n) for k in range(n)]:
        along = (place[a] - place[b]) / np.linalg.norm(place[a] - place[b])
        pair = np.zeros(2 * n + 2)
        pair[2 * a:2 * a + 2], pair[2 * b:2 * b + 2] = along, -along
        stiffness += np.outer(pair, pair)
    root = 1.0 / np.sqrt(np.repeat([point_share(n)] * n + [1.0 - n * point_share(n)], 2))
    return float(np.linalg.eigvalsh(root[:, None] * stiffness * root)[-1])


def axes_of(drive, motion):
    return [axis for axis in AXES if axis not in UNKNOWN[motion] + DRIVES[drive]]


def scenes(short):
    """Each axis by itself, then both ends of each with both ends of every other."""
    if short:
        return [Scene(*one) for one in SHORT]
    found = []
    for drive, motion in itertools.product(DRIVES, INTEGRATORS):
        axes = axes_of(drive, motion)
        found.append(Scene(drive, motion, {}))
        found += [Scene(drive, motion, {axis: value}) for axis in axes for value in AXES[axis]]
        found += [Scene(drive, motion, {one: a, other: b}) for one, other in itertools.combinations(axes, 2)
                  for a in (AXES[one][0], AXES[one][-1]) for b in (AXES[other][0], AXES[other][-1])]
    return found
