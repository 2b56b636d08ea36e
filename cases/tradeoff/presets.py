"""The presets of the command `accuracy`, as the study measures them. tests/coupling/test_tradeoff.py holds them against what the command says."""

PRESETS = {
    "fast": {"points": 24, "across": 8, "cfl": 0.8},
    "balanced": {"points": 36, "across": 12, "cfl": 0.6},
    "accurate": {"points": 72, "across": 24, "cfl": 0.4},
}
CFL_OF_STEP = {"fall": 1.15, "stream": 1.6}  # the CFL number over the cells that the disc, or the stream, moves in a fluid step; elsewhere the step is not bound by the flow


def in_scene(name, scene):
    """A scene's knobs as the preset sets them."""
    preset = PRESETS[name]
    changes = {"across": preset["across"], "points": preset["points"] / preset["across"]}
    if scene.name in CFL_OF_STEP:
        changes["step"] = round(preset["cfl"] / CFL_OF_STEP[scene.name], 3)
    return {**scene.default, **{knob: value for knob, value in changes.items() if knob in scene.default}}
