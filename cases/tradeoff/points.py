"""The points of the study: which settings of which scenes, and what is measured of each."""

import itertools

import presets
import scenes
import study

GRID = {"across": (6, 8, 12, 16, 24), "step": (0.5, 1, 2), "points": (1.5, 3, 6)}  # steps as factors of the default
SHORT = {"fall": (4, 8, 12), "bed": (4, 8, 12)}  # scenes of the short form, and cells across an object in them
FINE, START = "fine", "start"                    # the run that others are compared with, and that which tells what they spend before they begin
REPEATS, CHEAP = 3, 12                           # how often runs are repeated, up to so many cells across an object: their costs are small
LEAST = 0.01                                     # seconds that can be told from nothing


def changed(scene, **changes):
    """The default with some knobs turned; steps as factors."""
    step = scene.default["step"] * changes.pop("step", 1)
    return {**scene.default, "step": step, **changes}


def swept(scene, knob, value):
    return changed(scene, **(value if isinstance(value, dict) else {knob: value}))


def grid(scene):
    """By cells across, factor of the step and number of points: settings of a scene in which the grid makes sense. Where points are no knob they count nothing."""
    if "across" not in scene.sweeps:
        return {}
    return {values: changed(scene, **{knob: value for knob, value in zip(GRID, values) if knob in scene.default}) for values in itertools.product(*GRID.values())}


def has_presets(scene):
    return "across" in scene.sweeps


def settings(scene, short):
    """Each once, the default first."""
    if short:
        return [changed(scene, across=across) for across in SHORT[scene.name]]
    wanted = [scene.default, *(swept(scene, knob, value) for knob, values in scene.sweeps.items() for value in values), *grid(scene).values()]
    if has_presets(scene):
        wanted += [presets.in_scene(name, scene) for name in presets.PRESETS]
    return [setting for k, setting in enumerate(wanted) if setting not in wanted[:k]]


def name_of(scene, setting):
    differs = [f"{knob}{value}" for knob, value in setting.items() if value != scene.default[knob]]
    return f"{scene.name}_{'_'.join(differs) or 'default'}".replace("/", "-").replace(" ", "-")


def point(scene, setting, short, role=None):
    name = f"{scene.name}_{role}" if role else name_of(scene, setting)
    variables = {**scene.variables(setting), **(scene.start if role == START else {})}
    return study.Point(name, scene.case, variables, labels={"scene": scene.name, **setting}, weight=1.0 + (setting["across"] / 12) ** 3 * scene.default["step"] / setting["step"],
                       timeout=1800, discard=() if role == START else scene.discard, repeats=REPEATS if setting["across"] <= CHEAP and not short else 1)


def of(short):
    points = []
    for scene in scenes.SCENES:
        if short and scene.name not in SHORT:
            continue
        points.append(point(scene, scene.default, short, START))
        fine = scene.short_fine if short else scene.fine
        if fine:
            points.append(point(scene, {**scene.default, **fine}, short, FINE))
        points += [point(scene, setting, short) for setting in settings(scene, short)]
    return points


def measure(outcome, others):
    """Its errors, and its cost: CPU time less that of a run of next to no steps."""
    scene = next(scene for scene in scenes.SCENES if scene.name == outcome.point.labels["scene"])
    if not outcome.finished or outcome.point.name.endswith((f"_{START}", f"_{FINE}")):
        return {}
    cost = max(LEAST, outcome.cpu - others[f"{scene.name}_{START}"].cpu)
    fine = others[f"{scene.name}_{FINE}"].run() if scene.fine else None
    return {"cost": cost, **scene.error(outcome.run(), fine)}
