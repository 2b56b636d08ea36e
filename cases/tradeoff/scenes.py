"""The scenes of the study: what a setting of the knobs makes of a case's variables, and how far a run is from the truth.

Knobs have one name and one meaning in all scenes:
    across       fluid cells across an object
    step         fluid step: in the fall and the stream how many cells the disc or the stream moves in it; elsewhere over that of the scene as it stands, which falls with the cell
    every        DEM steps in a fluid step
    points       mass points on the ring of an object, over `across`: 3 is about one a cell
    marker_gap, kernel, projections, forcing, advection     words of fix fluid/ib
    integrator   of the objects
    contact      stiffness of contacts over that of the scene as it stands
A scene has those that mean something in it. Objects with springs have a number of points: k_s is that of one spring, so that another number is another object.
"""

import math
import sys
from dataclasses import dataclass

import numpy as np

import caselib
import drag
import ellipses
import fields
import frames
import histories

sys.path.append(str(caselib.CASES / "random_array"))
import measure as array  # noqa: E402

METHOD = {"marker_gap": 1, "kernel": "roma_1999", "projections": 2, "forcing": "direct"}
KERNELS = ("peskin_2002", "yang_2009", "gruninger_2025")
ACROSS, STEPS, POINTS, GAPS = (4, 6, 8, 12, 16, 24), (0.25, 0.5, 2, 3, 4), (1, 1.5, 2, 4.5, 6), (0.5, 2, 4)
BOUNDED = ("bounded", {"advection": "bounded", "step": 0.5})
FAR = 1000  # a time between frames or files: none are wanted


@dataclass
class Scene:
    name: str
    case: str
    title: str
    default: dict           # of the knobs
    fine: dict              # knobs of the solution that others are compared with; None: the exact one is known
    short_fine: dict        # the same in the study's short form
    start: dict             # variables of a run of next to no steps: what its time is, all points spend before they begin
    sweeps: dict            # by knob, values besides its default, or changes of several; those of step are factors
    variables: object       # of the case, from a setting
    error: object           # of a run, from it and the fine run: {"error": what counts, …}
    discard: tuple = ()     # what error does not need


def history_of(run, column, times):
    history = histories.History(run)
    return np.interp(times, history.time, history[column])


def root_mean_square(values):
    return float(np.sqrt(np.mean(np.square(values))))


def ring(setting):
    return round(setting["points"] * setting["across"])


def method(setting):
    return {key: setting[key] for key in METHOD}


# A disc that falls, case A

SPEED, FALL = 5.58, 0.6  # greatest speed, and time until which it falls freely


def fall_variables(setting):
    cells = round(8 * setting["across"])  # the box is eight diameters wide
    return {**method(setting), "cells": cells, "timestep": f"{setting['step']}*2/({SPEED}*{cells}*{setting['every']})", "every": setting["every"], "points": ring(setting),
            "advection": setting["advection"], "integrator": setting["integrator"], "t_end": FALL, "t_frame": FAR}


def fall_error(run, fine):
    times = np.linspace(0.02, 0.98 * FALL, 57)
    speed, true = (history_of(one, "vy", times) for one in (run, fine))
    history = histories.History(run)
    return {"error": root_mean_square(speed - true) / SPEED, "peak_error": float(np.abs(history["vy"]).max()) / SPEED - 1, "cfl": float(history["cfl"].max())}


# 16 soft discs that swell in a cavity whose lid moves, until they begin to press each other

GROWN = 4.0  # later the motion is chaotic
LATTICE = np.array([(0.164 + 0.224 * i, 0.164 + 0.224 * j) for j in range(4) for i in range(4)])


def cavity_variables(setting, duration=GROWN):
    fluid_step = 5e-3 * setting["step"] * 12 / setting["across"]
    every = math.ceil(setting["every"] * math.sqrt(max(1.0, setting["contact"])))  # stiffer contacts want shorter DEM steps
    return {**method(setting), "rate": 6e-3, "t_end": duration, "cells": round(setting["across"] / 0.12),
            "timestep": duration / (math.ceil(duration / fluid_step - 1e-9) * every), "every": every,
            "kn": 1e4 * setting["contact"], "advection": setting["advection"], "integrator": setting["integrator"], "t_frame": duration, "t_save": FAR}


def centres(run):
    """Of the objects, in the order of their ids."""
    polygons, values = frames.outlines(frames.Series(run.folder / "post", "outline").frames[-1][1])
    shapes = [ellipses.of_polygon(polygon) for polygon in polygons]
    return np.array([(shape.x, shape.y) for shape in shapes])[np.argsort(values["object_id"])]


def cavity_error(run, fine):
    mine, true = centres(run), centres(fine)
    return {"error": root_mean_square(mine - true) / root_mean_square(true - LATTICE)}


# The same under a lid at rest, until they have long pressed each other; for contacts alone, in one fluid

PRESSED = {"rate": 1e-2, "dmax": 0.19, "t_end": 7, "t_frame": FAR, "u_top": 0}


def press_variables(setting):
    return {**cavity_variables(setting, PRESSED["t_end"]), **PRESSED}


def press_error(run, fine):
    """Of what the objects' mean diameter lacks."""
    times = np.linspace(5, 6.4, 15)
    mine, true = (history_of(one, "natural_diameter", times) - history_of(one, "area_diameter", times) for one in (run, fine))
    return {"error": root_mean_square(mine - true) / root_mean_square(true), "lacking": float(mine[-1])}


# A disc held in a stream

def stream_variables(setting):
    return {**method(setting), "re": 20, "width": 12, "height": 8, "upstream": 4, "t_end": 15, "t_reading": 0.1, "cells": setting["across"], "cfl": 1.5 * setting["step"],
            "points": ring(setting), "advection": setting["advection"]}


def stream_error(run, fine):
    """The larger of those of the drag and of the length of the wake: one alone may pass through zero."""
    (mine, wake), (true, true_wake) = ((drag.coefficient(history_of(one, "drag", np.linspace(3, 15, 25)), 1.0, 1.0), wake_of(one)) for one in (run, fine))
    drag_error, wake_error = root_mean_square(mine / true - 1), abs(wake / true_wake - 1)
    return {"error": max(drag_error, wake_error), "drag_error": drag_error, "wake_error": wake_error, "cfl": run.thermo()[-1]["water[4]"]}


def wake_of(run):
    """0 without one."""
    outline = frames.outlines(frames.Series(run.folder / "post", "outline").frames[-1][1])[0][0]
    return drag.wake_length(fields.last(run), outline.mean(axis=0), 1.0) or 0.0


# A capsule in shear

def capsule_variables(setting):
    return {**method(setting), "box": 8, "t_end": 2, "across": setting["across"] / 2, "c": 0.3 * setting["step"], "per_cell": setting["points"] / math.pi}


def capsule_error(run, fine):
    mine, true = ([shape for _, shape in ellipses.of_run(one)] for one in (run, fine))
    off = [a.deformation - b.deformation for a, b in zip(mine, true)]
    return {"error": root_mean_square(off) / true[-1].deformation, "area_error": max(abs(shape.area / mine[0].area - 1) for shape in mine)}


# Creeping flow through a bed of discs

def bed_variables(setting):
    return {**method(setting), "discs": 10, "cells": setting["across"], "z": 4 * setting["step"], "points": ring(setting)}


def bed_error(run, _):
    return {"error": abs(array.permeability(run)[0] / array.exact_permeability(run)[0] - 1)}


SCENES = [
    Scene("fall", "sedimentation", "a disc that falls", {"across": 12, "step": 0.5, "every": 1, "points": 3, **METHOD, "advection": "central", "integrator": "rigid/cds"},
          {"across": 48, "step": 0.25}, {"across": 16}, {"t_end": 1e-4},
          {"across": ACROSS, "step": STEPS, "every": (4, 16), "points": POINTS, "marker_gap": GAPS, "kernel": KERNELS, "projections": (1,), "forcing": ("multi 3",),
           "advection": BOUNDED, "integrator": ("nve/cds implicit",)}, fall_variables, fall_error, ("post",)),
    Scene("cavity", "cavity_swelling", "16 soft discs that swell and are carried",
          {"across": 12, "step": 1, "every": 5, **METHOD, "advection": "central", "integrator": "nve/cds", "contact": 1},
          {"across": 48, "step": 0.5}, {"across": 16}, {"t_end": 1e-4},
          {"across": ACROSS, "step": (*STEPS, 8), "every": (2, 20), "marker_gap": GAPS, "kernel": KERNELS, "projections": (1,), "forcing": ("multi 3",), "advection": ("bounded",),
           "integrator": ("nve/cds implicit",), "contact": (0.1, 0.3, 3, 10)}, cavity_variables, cavity_error, ("post/fields*",)),
    Scene("press", "cavity_swelling", "16 soft discs that press each other",
          {"across": 8, "step": 1, "every": 5, **METHOD, "advection": "central", "integrator": "nve/cds", "contact": 1}, {"contact": 100}, {"contact": 10}, {"t_end": 1e-4},
          {"every": (1, 2, 20), "integrator": ("nve/cds implicit",), "contact": (0.03, 0.1, 0.3, 3, 10, 30)}, press_variables, press_error, ("post",)),
    Scene("stream", "cylinder", "a disc held in a stream", {"across": 12, "step": 0.25, "points": 3, **METHOD, "advection": "central"},
          {"across": 48}, {"across": 16}, {"t_end": 1e-3, "t_reading": 1e-3},
          {"across": ACROSS, "step": STEPS, "points": POINTS, "marker_gap": GAPS, "kernel": KERNELS, "projections": (1,), "forcing": ("multi 3", "implicit"), "advection": BOUNDED},
          stream_variables, stream_error),
    Scene("capsule", "capsule", "a capsule in shear", {"across": 12, "step": 1, "points": 3, **METHOD, "kernel": "gruninger_2025"},
          {"across": 48, "step": 0.5}, {"across": 16}, {"t_end": 1e-3, "reading": 1e-3},
          {"across": ACROSS, "step": STEPS, "points": POINTS, "marker_gap": GAPS, "kernel": ("roma_1999", *KERNELS[:2]), "projections": (1,), "forcing": ("multi 3",)},
          capsule_variables, capsule_error, ("post",)),
    Scene("bed", "random_array", "creeping flow through a bed of discs", {"across": 12, "step": 1, "points": 3, **METHOD}, None, None, {"t_end": 1e-4},
          {"across": ACROSS, "step": STEPS, "points": POINTS, "marker_gap": GAPS, "kernel": KERNELS, "projections": (1,), "forcing": ("multi 3", "implicit")},
          bed_variables, bed_error, ("post",)),
]
