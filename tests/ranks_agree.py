#!/usr/bin/python3
"""ranks_agree.py FOLDER: the cavity on 1, 2 and 4 ranks is the same after 200 fluid steps, to 1e-9 of each array's largest value."""

import subprocess
import sys
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "cases"))
import numpy as np  # noqa: E402

import caselib  # noqa: E402
import frames  # noqa: E402

CASE = caselib.Case("cavity_swelling")
STEPS = 200
TOLERANCE = 1e-9
RANKS = (1, 2, 4)


def run(folder, ranks):
    variables = CASE.declared_variables()
    t_end = repr(STEPS * int(variables["every"]) * float(variables["timestep"]))
    command = [str(caselib.CASES / "run"), CASE.name, "--np", str(ranks), "--out", str(folder), "-var", "t_end", t_end, "-var", "t_frame", t_end]
    subprocess.run(command, check=True, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL)


def state(folder):
    """{name: array} of the last frame, points in order of their tags."""
    def last(name):
        return list(frames.Series(folder / "post", name))[-1]

    time, file = last("points")
    positions, values = frames.vertices(file)
    order = np.argsort(values["tag"])
    result = {"time": np.array([time]), "position": positions[order], "point velocity": values["velocity"][order]}
    _, _, fields = frames.fields(last("fields")[1])
    return {**result, "fluid velocity": fields["velocity"], "fluid pressure": fields["pressure"]}


def main(folder):
    states = {}
    for ranks in RANKS:
        run(folder / f"np{ranks}", ranks)
        states[ranks] = state(folder / f"np{ranks}")
    table, worst = caselib.Table(), 0.0
    for ranks in RANKS[1:]:
        for name, expected in states[RANKS[0]].items():
            difference = np.abs(states[ranks][name] - expected).max() / np.abs(expected).max()
            table.at_most(f"{name}, {ranks} ranks against 1", difference, TOLERANCE)
            worst = max(worst, difference)
    table.finish("largest relative difference", float(worst))


if __name__ == "__main__":
    main(Path(sys.argv[1]).absolute())
