"""What became of a point, and why; the bounds are what physics gives.

A run that finishes and breaks a bound is wrong, whatever its own table of accuracy says; what that calls poor is kept beside it.
"""

import re

import numpy as np

import caselib
import histories
import points
import study

RIGHT, REFUSED, ENDED, WRONG = ENDINGS = ("right", "refused", "ended", "wrong")
ROUND_OFF = 1e-9     # of what must vanish, over its largest part
SLIP = 0.05          # mean slip at the markers, beyond vibrations, over the speed of discs, fluid and growth, median over time: in collisions, and when growth begins, it is more
AREA = 0.05          # of a disc's area or natural area
SPEED = 0.1          # beyond the largest speed that forces can give, or backwards
MOMENTUM = 0.01      # of that of the fluid, besides what the start's jump gives in a step, in which it comes late: the share that follows of the fluid inside
ENERGY = 0.05        # beyond what is there
STRAY = 0.01         # of the speed of growth, that a disc may have besides: markers take a share like that of a law's start for motion
MISSING = 0.01       # share of what an outline lacks that it makes up for in a fluid step, docs/theory.md, *Absorption*
NEAR = 0.02          # diameters: gaps below it may close between two readings
EARLY = 10           # fluid steps until the fluid, which starts at once, meets discs with no more than its usual slip


class Motion:
    """A finished run: its history, and what each disc did, [reading, disc]."""

    def __init__(self, outcome, scene):
        run = outcome.run()
        self.scene = scene
        self.variables = run.variables
        self.history = histories.History(run)
        rows = caselib.read_csv(run.folder / "objects.csv")
        self.discs = {key.split(" ")[0]: np.array([row[key] for row in rows]).reshape(-1, 2) for key in rows[0]}
        self.start = {key: values[0] for key, values in self.discs.items()}
        self.discs = {key: values[1:] for key, values in self.discs.items()}  # history.csv begins a fluid step later
        self.time = self.history.time

    def __getattr__(self, name):
        return self.variables[name]

    @property
    def fluid_step(self):
        return self.dt * self.every

    def finite(self):
        return self.history.finite() and all(np.isfinite(values).all() for values in self.discs.values())

    def speeds(self):
        return np.hypot(self.discs["velocity_x"], self.discs["velocity_y"])

    def growth(self):
        """Speed of an outline."""
        return abs(self.rate) / 2 if self.drive == "weight" else 0.0

    def law_is_on(self):
        return self.growth() * (self.time - self.fluid_step) < abs(self.ratio - 1.0) / 2

    def ring_share(self):
        """Of a disc's mass."""
        return self.points * points.point_share(int(self.points))

    def whole_energy(self):
        """Of each disc's motion as a whole, as of one that is rigid."""
        mass, spin = self.discs["mass"], self.discs["spin"] * self.discs["natural_diameter"]
        return mass * (self.speeds() ** 2 / 2 + spin**2 / 16)

    def inner_energy(self):
        """Of both discs' vibrations and growth."""
        return np.maximum(self.discs["kinetic_energy"] - self.whole_energy(), 0.0).sum(axis=1)

    def vibration(self):
        """Largest speed in a period of the ring points against the motion as a whole and against growth: twice the mean square over time, of both discs."""
        square = 2 * 2 * self.inner_energy() / (self.ring_share() * self.discs["mass"].sum(axis=1))
        square = np.maximum(square - np.where(self.law_is_on(), 2 * self.growth() ** 2, 0.0), 0.0)
        breathing = 0.0 if self.scene.motion == "rigid" else np.pi / (self.scene.breathing_frequency() * self.fluid_step)
        return np.sqrt(self.averaged(square, breathing))

    def averaged(self, values, least=0.0):
        """Over the period in which the force of the markers, carried from step to step, lends and returns energy; half of it is `least` readings or more."""
        window = np.ones(1 + 2 * round(max(least, np.pi / swing_angle(self))))
        if len(values) < len(window):
            return np.full(len(values), values.mean() if len(values) else 0.0)
        return np.convolve(values, window, "same") / np.convolve(np.ones(len(values)), window, "same")

    def touched(self):
        """Whether anything met, also between readings: spheres of 1/10 about mass points meet walls, and discs each other."""
        size = np.maximum(self.discs["swelling_ratio"].max(axis=1), 1.0)
        history, apart = self.history, np.hypot(*(np.diff(self.discs[f"centroid_{axis}"], axis=1)[:, 0] for axis in "xy"))
        gap = np.minimum.reduce([history["xlo"], self.width - history["xhi"], history["ylo"], 2 * self.width - history["yhi"], apart - 0.9 * size])
        return self.discs["contact_force"].max() > 0.0 or (gap < (0.1 + NEAR) * size).any()

    def flow_speed(self):
        """The fluid's largest, up to each reading."""
        return np.maximum.accumulate(self.history["cfl"]) / self.fluid_step / self.across


def findings(scene, motion):
    """(what is judged, value, bound) of all that must hold: value at most bound."""
    yield "values that are not finite", 0 if motion.finite() else 1, 0
    yield "momentum that is not exchanged", motion.history["momentum_error"].max(), ROUND_OFF * max(1.0, heaviness(motion))
    yield "divergence", (motion.history["divergence"] / motion.across / np.maximum(motion.flow_speed(), 1e-12)).max(), ROUND_OFF
    yield "slip over speed, median", slip(motion), SLIP
    yield "an outline inside out", -motion.discs["area_ratio"].min(), 0.0
    yield from areas(scene, motion)
    yield from {"weight": closed_box, "stream": free_box}[motion.drive](scene, motion)


def heaviness(motion):
    """A disc's weight over what it weighs in the fluid, which its impulses are as large as."""
    excess = abs(motion.density - 1.0)
    return motion.density / excess if excess > 0.0 else 1.0


def slip(motion):
    """Vibrations of undamped springs are the discs' own: the fluid meets their mean over its step. How large they may be, energies and areas tell."""
    late = slice(min(EARLY, len(motion.time) // 2), None)
    speed = np.maximum.accumulate(np.maximum(motion.speeds().max(axis=1), motion.flow_speed())) + motion.growth()
    return float(np.median(((motion.history["slip"] - motion.vibration()) / speed)[late]))


# Areas: the fluid inside does not give way, and nothing drinks more than its natural size has room for

def areas(scene, motion):
    area, natural = motion.discs["area"], motion.discs["area"] / motion.discs["area_ratio"]
    bound = AREA + 2 * overshoot(motion)
    yield "area over the larger of the natural one and that of the start, less 1", (area / np.maximum(natural, motion.start["area"])).max() - 1.0, bound
    yield "1 less area over the smaller of the natural one and that of the start", 1.0 - (area / np.minimum(natural, motion.start["area"])).min(), bound
    settled = ~motion.law_is_on()
    if motion.drive == "weight" and settled.sum() >= points.SETTLING and not motion.touched() and scene.ks >= 100:
        lacks = abs(np.sqrt(motion.discs["area_ratio"][settled]) - 1.0).max(axis=1)
        yield "size that lacks at the end, relative", lacks[-1], AREA + overshoot(motion) + lacks[0] * (1.0 - MISSING) ** len(lacks)


def overshoot(motion):
    """Of a radius, relative: that of points on springs whose other ends set out at once, which grow on as fast until the springs turn them."""
    if motion.scene.motion == "rigid" or not motion.growth():
        return 0.0
    size = min(1.0, motion.ratio)
    return min(2 * motion.growth() / motion.scene.breathing_frequency(), abs(motion.ratio - 1.0)) / size


# weight: nothing leaves the box, and what moves falls

def closed_box(scene, motion):
    history = motion.history
    beyond = max(-history["xlo"].min(), history["xhi"].max() - motion.width, -history["ylo"].min(), history["yhi"].max() - 2 * motion.width)
    yield "a mass point beyond a side", beyond, 0.0
    yield "area of the discs over that of the box", motion.discs["area"].sum(axis=1).max() / (2 * motion.width**2), 1.0
    most = given(motion)
    if scene.motion == "rigid":
        yield "width of a disc that cannot give way over that of the box", motion.discs["natural_diameter"].max() / motion.width, 1.0
    yield "kinetic energy over what weight, springs, contacts and growth gave", kinetic(motion).max() / most, 1.0 + ENERGY
    yield "energy gained after growth beyond that of contacts, over the same", gained_after_growth(motion) / most, ENERGY
    if not motion.touched():
        yield from falling(scene, motion)


def falling(scene, motion):
    most, stray = fastest(scene, motion), STRAY * motion.growth()
    down = -np.sign(motion.density - 1.0) * motion.discs["velocity_y"]
    bound = SPEED + stray / most.max()
    yield "speed of a disc beyond what its weight can give it up to then, over the largest", (down.max(axis=1) - most).max() / most.max(), bound
    yield "velocity against the weight over that", -down.min() / most.max(), bound
    yield "velocity sideways over that", np.abs(motion.discs["velocity_x"]).max() / most.max(), bound


def fastest(scene, motion):
    """The free fall with the added mass of a disc in an ideal fluid, or creeping motion between plates; and the hub, which no fluid holds, swings by as much as it sags.

    The stiffness against it is half of that of all springs; it weighs what it does in the fluid and what that loses by moving with the ring. A disc of the fluid's density is
    not moved at all: of what would move it a thousandth is let pass.
    """
    net = max(abs(motion.density - 1.0), 1e-3) * motion.gravity
    largest = max(1.0, motion.ratio)
    creeping = net * np.pi / 4 * largest**2 * motion.re / scene.creeping_drag()
    hub_share = 1.0 - motion.ring_share()
    hub = hub_share * motion.start["mass"].max() * largest**2
    swing = hub_share * net / motion.density * (1.0 + 1.0 / (motion.density + 1.0)) * np.sqrt(hub / (0.5 * motion.points * motion.ks))
    return np.minimum(creeping, net / (motion.density + 1.0) * (motion.time + motion.fluid_step)) + swing


def excess(motion):
    """Of the discs' mass over the fluid's, relative: the fluid's energy and momentum have what is inside the discs."""
    return 1.0 - 1.0 / motion.density


def kinetic(motion):
    """Of all. The fluid inside moves with a disc as a whole, and does not vibrate with its points."""
    return motion.history["fluid_energy"] + excess(motion) * motion.whole_energy().sum(axis=1) + motion.inner_energy()


def weight_of(motion):
    return (motion.density - 1.0) / motion.density * motion.discs["mass"].max() * motion.gravity


def of_contacts(motion):
    """Energy of contacts, at most: that of one with all of the force, f^2 / 2 k."""
    return motion.discs["contact_force"].sum(axis=1) ** 2 / (2 * motion.kn)


def given(motion):
    """Upper bounds: of a spring's energy and that of contacts the largest at any time; of growth that which points on springs have whose other ends set out at once, twice as fast.

    What drinks is heavier with the velocity that it had.
    """
    fallen = np.abs(motion.discs["centroid_y"] - motion.start["centroid_y"]).max(axis=0).sum()
    both = motion.discs["mass"].max(axis=0).sum()
    of_growth = 0.5 * motion.ring_share() * both * (2 * motion.growth()) ** 2
    least = 1e-6 * motion.start["mass"].sum()
    heavier = max(1.0, both / motion.start["mass"].sum())
    return heavier * (abs(weight_of(motion)) * fallen + motion.history["spring_energy"].max() + of_contacts(motion).max() + of_growth + least)


def gained_after_growth(motion):
    """By all but contacts, beyond what these had before."""
    settled = ~motion.law_is_on()
    energy = kinetic(motion) + motion.history["spring_energy"] + weight_of(motion) * motion.discs["centroid_y"].sum(axis=1)
    energy, contacts = (motion.averaged(values[settled]) for values in (energy, of_contacts(motion)))
    return gained(energy, contacts)


def gained(energy, contacts):
    return (energy - np.minimum.accumulate(energy + contacts)).max(initial=0.0)


# stream: no source of energy, none of momentum

def free_box(scene, motion):
    both = motion.start["mass"].sum()
    inside = both / motion.density
    outside = 2 * motion.width**2 - inside  # what is inside the discs moves as they do: after the jump of the start, in which it begins as all of the fluid
    begin = 0.5 * 2 * motion.width**2 + 0.5 * both * 0.5**2
    energy, contacts = motion.averaged(kinetic(motion) + motion.history["spring_energy"]), motion.averaged(of_contacts(motion))
    late = slice(len(energy) // 2, None)
    yield "energy over that of the start", energy.max() / begin, 1.0
    yield "energy gained in the second half beyond that of contacts, over that of the start", gained(energy[late], contacts[late]) / begin, ENERGY
    momentum = motion.history["px"] + excess(motion) * (motion.discs["velocity_x"] * motion.discs["mass"]).sum(axis=1)
    yield "momentum gained or lost at the end, over that of the start", abs(momentum[-1] / outside - 1.0), MOMENTUM + follows(motion) * inside / outside
    along = motion.discs["velocity_x"] / (1.0 + swing_of_force(motion))[:, None]
    yield "velocity of a disc over the stream's, beyond the swing of a jump", along.max(), 1.0 + SPEED
    yield "velocity of a disc against the stream over it", -along.min(), SPEED


# How fast a force answers (docs/theory.md)

def follows(motion):
    """Share of a jump that the fluid inside a disc follows in a step: a layer of 2 h moves at once."""
    return min(4.0 / motion.across, 0.9)


def swing_angle(motion):
    """By which force and velocity go on in their swing in a step."""
    return np.arctan(np.sqrt(follows(motion) / (1.0 - follows(motion))))


def swing_of_force(motion):
    """What is left of a jump in force and velocity after each step."""
    return (1.0 - follows(motion)) ** (0.5 * np.arange(len(motion.time)))


# The verdict

def measure(outcome, scene):
    if not outcome.finished:
        return failure(outcome)
    motion = Motion(outcome, scene)
    broken = [(name, value, bound) for name, value, bound in findings(scene, motion) if not value <= bound]
    why = "; ".join(f"{name} {value:.3g}, at most {bound:.3g}" for name, value, bound in broken)
    return {"ending": WRONG if broken else RIGHT, "why": why, "poor": "; ".join(poor_figures(outcome.folder / "log.liggghts"))}


def poor_figures(log):
    """Of the table at the end of a run."""
    table = log.read_text(errors="replace").rpartition("Accuracy of the run")[2]
    return re.findall(r"^  (\S.*?)  .*\bpoor$", table, re.M)


def failure(outcome):
    """An error that names itself, with the exit code of an error, on a run that had not begun or after some steps; anything else is a crash or a hang."""
    if outcome.status != study.FAILED or outcome.exit_code != 1 or not outcome.message.startswith("ERROR"):
        return {"ending": WRONG, "why": f"{outcome.status}, exit code {outcome.exit_code}: {outcome.message}"}
    history = outcome.folder / "history.csv"
    begun = history.exists() and len(history.read_text().splitlines()) > 1
    return {"ending": ENDED if begun else REFUSED, "why": re.sub(r" \(\S*:\d+\)$", "", outcome.message)}
