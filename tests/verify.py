#!/usr/bin/python3
"""The long proofs: ./bootstrap verify [NAME]. A part that passed is not run again until the sources change.

Each part is a function that runs for less than an hour and returns its exit code. It prints its figure last.
"""

import hashlib
import os
import subprocess
import sys
import time
from pathlib import Path

sys.dont_write_bytecode = True
ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT / "cases"))
import caselib  # noqa: E402

FOLDER = ROOT / "results" / "verify"
SOURCES = ("CMakeLists.txt", "cmake", "fluid", "liggghts_plugins", "coupling", "cases", "tests/verify.py", "tests/ranks_agree.py")


def case(name, folder, *arguments):
    """cases/run into a folder of its own; the exit code. What it says is kept beside that folder, for docs/verification/figures."""
    command = [str(caselib.CASES / "run"), name, "--out", str(FOLDER / folder), *arguments]
    print("$ " + " ".join(command), flush=True)
    kept = FOLDER / f"{folder}.txt"
    kept.parent.mkdir(parents=True, exist_ok=True)
    with open(kept, "w") as file, subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True) as run:
        for line in run.stdout:
            print(line, end="", flush=True)
            file.write(line)
    return run.returncode


def cavity_stiff():
    return case("cavity_swelling", "cavity_stiff", "--np", "2", "--check")


def cavity_soft():
    return case("cavity_swelling", "cavity_soft", "--np", "2", "-var", "ks", "100", "--check")


def cavity_ranks():
    return subprocess.run([sys.executable, str(ROOT / "tests" / "ranks_agree.py"), str(FOLDER / "cavity_ranks")]).returncode


def all_of(folder, runs, ranks=2):
    """Runs cases with --check, each into a folder of its own within `folder`; every one of them runs, whatever became of those before."""
    codes = [case(name, f"{folder}/{sub}", "--np", str(ranks), *(word for key, value in variables.items() for word in ("-var", key, str(value))), "--check")
             for name, sub, variables in runs]
    return max(codes)


def flow_cavity():
    return all_of("cavity", [("lid_driven_cavity", f"re{re}_{cells}", {"re": re, "cells": cells})
                             for re, cells in ((10, 128), (100, 128), (100, 256), (400, 256), (1000, 256))])


def flow_channel():
    return all_of("channel", [("channel", f"{flow}_{along}", {"flow": flow, "along": along})
                              for flow in ("pressure", "force", "flow_rate", "inflow", "couette", "film") for along in "xy"])


def flow_arrays():
    return all_of("arrays", [("square_array", f"phi{phi}", {"phi": phi}) for phi in (0.05, 0.1, 0.3, 0.5)])


def flow_stokes_channel():
    return all_of("stokes_channel", [("stokes_channel", f"{setting}_{k}", {"setting": setting, "k": k})
                                     for setting, k in (("inflow", 0.1), ("inflow", 0.25), ("inflow", 0.5), ("periodic", 0.25), ("moving", 0.25))])


def flow_schaefer_turek():
    return all_of("schaefer_turek", [("schaefer_turek", "cells100", {"cells": 100, "t_end": 20})])


def flow_cylinder_steady():
    return all_of("cylinder", [("cylinder", f"re{re}", {"re": re}) for re in (20, 40)])


def flow_cylinder_shedding():
    return all_of("cylinder", [("cylinder", "re100", {"re": 100, "cells": 32})])


def hydrogel():
    return all_of("hydrogel", [("hydrogel", form, {"law": form}) for form in ("printed", "reconstructed")], ranks=1)


PARTS = {
    "cavity_stiff": (cavity_stiff, "the paper's cavity with k_s = 1000, to t = 110"),
    "cavity_soft": (cavity_soft, "the paper's cavity with k_s = 100, to t = 110"),
    "hydrogel": (hydrogel, "the paper's bead over 9.7 hours, by both forms of its law"),
    "flow_cavity": (flow_cavity, "lid-driven cavity, Re 10 to 1000, against published extrema"),
    "flow_channel": (flow_channel, "Poiseuille and Couette, driven in every way, along x and along y"),
    "flow_arrays": (flow_arrays, "creeping flow through square arrays of discs, with refinement and time steps"),
    "flow_stokes_channel": (flow_stokes_channel, "creeping flow around a cylinder between walls"),
    "flow_schaefer_turek": (flow_schaefer_turek, "benchmark 2D-1, 100 cells across the cylinder"),
    "flow_cylinder_steady": (flow_cylinder_steady, "cylinder in a stream, Re 20 and 40"),
    "flow_cylinder_shedding": (flow_cylinder_shedding, "cylinder in a stream, Re 100, 32 cells across it"),
    "cavity_ranks": (cavity_ranks, "200 fluid steps of the cavity agree on 1, 2 and 4 ranks"),
}


def fingerprint():
    digest = hashlib.sha256()
    for source in SOURCES:
        path = ROOT / source
        files = sorted(file for file in path.rglob("*") if file.is_file() and "__pycache__" not in file.parts) if path.is_dir() else [path]
        for file in files:
            digest.update(str(file.relative_to(ROOT)).encode() + b"\0" + file.read_bytes())
    return digest.hexdigest()


def verify(name, now):
    """True when the part holds for these sources."""
    run, words = PARTS[name]
    proof = FOLDER / f"{name}.passed"
    if proof.exists() and proof.read_text() == now:
        print(f"== {name}: {words}: holds, proved before for these sources")
        return True
    print(f"== {name}: {words}", flush=True)
    proof.unlink(missing_ok=True)
    start = time.monotonic()
    passed = run() == 0
    print(f"== {name}: {'holds' if passed else 'FAILED'} after {time.monotonic() - start:.0f} s", flush=True)
    if passed:
        partial = proof.with_suffix(".partial")
        partial.write_text(now)
        os.replace(partial, proof)
    return passed


def main(names):
    unknown = [name for name in names if name not in PARTS]
    if unknown:
        sys.exit(f"verify: unknown part '{unknown[0]}'. Known: {', '.join(PARTS)}")
    FOLDER.mkdir(parents=True, exist_ok=True)
    now = fingerprint()
    failed = [name for name in names or PARTS if not verify(name, now)]
    print(f"{len(names or PARTS) - len(failed)} passed, {len(failed)} failed")
    sys.exit(1 if failed else 0)


if __name__ == "__main__":
    main(sys.argv[1:])
