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
SOURCES = ("CMakeLists.txt", "cmake", "fluid", "liggghts_plugins", "coupling", "cases", "packaging", "bootstrap", "tests/verify.py", "tests/decomposition.py",
           "tests/continued.py", "tests/coupling/test_continued.py", "tests/robustness/test_kills.py", "tests/debian_package.sh", "tests/bare_debian.sh")


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


def swelling_clock():
    return all_of("swelling_clock", [("swelling_clock", f"bed_{clock}", {"clock": clock}) for clock in (3, 10, 30)] +
                                    [("swelling_clock", f"shear_{clock}", {"scene": "shear", "clock": clock, "rate": 2e-3, "T": 125}) for clock in (100, 300, 1000)])


def swelling_bed_gap():
    """Gaps other than two cells are there for the README's table alone: what smaller ones hold back is the grid's work, not the beads', and larger ones choke less."""
    narrow = ("--np", "2", "-var", "beads", "100", "-var", "across", "10")
    beds = {"reach_0.05": ("reach", "0.05"), "reach_0.075": ("reach", "0.075"), "reach_0.1": ("reach", "0.1", "--check"), "no_swelling": ("swelling", "0", "--check"),
            "reach_0.15": ("reach", "0.15", "-var", "cds", "0.15", "-var", "fraction", "0.48")}
    return max([case("swelling_bed", f"swelling_bed_gap/{name}", *narrow, "-var", *words) for name, words in beds.items()])


def decomposition():
    return subprocess.run([sys.executable, str(ROOT / "tests" / "decomposition.py"), str(FOLDER / "decomposition")]).returncode


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


def random_arrays():
    return all_of("random_arrays", [("random_array", f"phi{phi}_seed{seed}", {"phi": phi, "seed": seed}) for phi in (0.1, 0.3, 0.5) for seed in (1, 2, 3)]
                                   + [("random_array", "phi0.5_cells40", {"phi": 0.5, "cells": 40})])


def flow_stokes_channel():
    return all_of("stokes_channel", [("stokes_channel", f"{setting}_{k}", {"setting": setting, "k": k})
                                     for setting, k in (("inflow", 0.1), ("inflow", 0.25), ("inflow", 0.5), ("periodic", 0.25), ("moving", 0.25))])


def taylor_dispersion():
    return all_of("taylor_dispersion", [("taylor_dispersion", f"pe{pe}_{cells}_{along}", {"pe": pe, "cells": cells, "along": along})
                                        for pe, cells, along in ((20, 16, "x"), (20, 32, "x"), (50, 32, "y"), (100, 16, "x"))])


def close_contact():
    return all_of("close_contact", [("close_contact", f"{met}_{cells}", {"with": met, "cells": cells}) for met in ("wall", "disc") for cells in (10, 20)] +
                                   [("close_contact", f"wall_{cells}_lubrication", {"cells": cells, "lubrication": 1.25}) for cells in (10, 20)])


def flow_schaefer_turek():
    return all_of("schaefer_turek", [("schaefer_turek", "cells100", {"cells": 100, "t_end": 20})])


def flow_cylinder_steady():
    return all_of("cylinder", [("cylinder", f"re{re}", {"re": re}) for re in (20, 40)])


def flow_cylinder_shedding():
    return all_of("cylinder", [("cylinder", "re100", {"re": 100, "cells": 32})])


def shear_rotation():
    return all_of("shear_rotation", [("shear_rotation", f"{motion}_{k}", {"motion": motion, "k": k})
                                     for motion, k in (("rigid", 0.1), ("rigid", 0.25), ("rigid", 0.5), ("implicit", 0.25), ("explicit", 0.25))])


def couette_migration():
    return all_of("couette_migration", [("couette_migration", f"{motion}_{cells}", {"motion": motion, "cells": cells})
                                        for motion, cells in (("rigid", 64), ("rigid", 128), ("implicit", 64))])


def hydrogel():
    return all_of("hydrogel", [("hydrogel", form, {"law": form}) for form in ("printed", "reconstructed")], ranks=1)


def sedimentation():
    return all_of("sedimentation", [("sedimentation", name, variables) for name, variables in (
        ("a_100", {}), ("a_100_implicit", {"integrator": "nve/cds implicit"}), ("a_100_explicit", {"integrator": "nve/cds", "every": 400}),
        ("a_200", {"cells": 200}), ("b_100", {"diameter": 0.5}), ("c_100", {"growth": 0.25}), ("c_100_implicit", {"growth": 0.25, "integrator": "nve/cds implicit"}))])


def sedimentation_mesh():
    return all_of("sedimentation", [("sedimentation", "a_300", {"cells": 300})])


def density_ratios():
    runs = []
    for density in (0.01, 0.1, 0.5, 0.9, 1, 1.0001, 1.1, 10, 1000):
        substeps = round(400 * max(1.0, density**-0.5))  # the explicit limit falls with the masses
        for name, variables in (("rigid", {}), ("rigid_re10", {"re": 10}), ("implicit", {"integrator": "nve/cds implicit"}),
                                ("implicit_re10", {"integrator": "nve/cds implicit", "re": 10}), ("explicit", {"integrator": "nve/cds", "every": substeps})):
            runs.append(("density_ratio", f"{name}_{density}", {"density": density, "reading": 10 if density == 1000 else 1, **variables}))
    return all_of("density_ratio", runs)


def elastic_ring():
    return all_of("elastic_ring", [("elastic_ring", "cells8", {"t_end": 20}), ("elastic_ring", "cells12", {"across": 12}), ("elastic_ring", "ratio2", {"ratio": 2})])


def capsule():
    return all_of("capsule", [("capsule", f"ca{Ca}", {"Ca": Ca, "t_end": t_end}) for Ca, t_end in ((0.01, 4), (0.05, 10), (0.1, 10))]
                  + [("capsule", "ca0.05_ratio10", {"ratio": 10, "across": 8}), ("capsule", "ca0.05_re0.0025", {"reynolds": 0.0025, "across": 8})])


def package():
    """Needs root, for the bare Debian 12 that it is installed in."""
    if code := subprocess.run([str(ROOT / "bootstrap"), "package"], stdin=subprocess.DEVNULL).returncode:
        return code
    [made] = (ROOT / "build-package").glob("*.deb")
    return subprocess.run([str(ROOT / "tests" / "debian_package.sh"), str(FOLDER / "bare_debian"), str(made)], stdin=subprocess.DEVNULL).returncode


def unittest_of(folder, test, **environment):
    """A test of the suite in its long form, which the environment asks for."""
    environment = {**os.environ, **environment, "SWELLFLOW_PROGRAM": str(caselib.program()), "PYTHONPATH": f"{ROOT / 'cases'}:{ROOT / 'tests'}"}
    return subprocess.run([sys.executable, "-B", "-m", "unittest", "-v", test], cwd=ROOT / "tests" / folder, env=environment, stdin=subprocess.DEVNULL).returncode


def kills():
    """As the test, but 200 kills."""
    return unittest_of("robustness", "test_kills.Kills", SWELLFLOW_KILLS="200")


def continued():
    """As the test, but from and to every number of ranks."""
    return unittest_of("coupling", "test_continued", SWELLFLOW_ALL_RANKS="1")


def build(folder, target, *options):
    """As ./bootstrap builds; whether it went well."""
    commands = (["cmake", "-S", str(ROOT), "-B", str(ROOT / folder), "-Wno-dev", *options],
                ["cmake", "--build", str(ROOT / folder), "--target", target, "-j", str(os.cpu_count())])
    return all(subprocess.run(command, stdin=subprocess.DEVNULL).returncode == 0 for command in commands)


SANITIZED = ("-DCMAKE_BUILD_TYPE=Debug", "-DSWELLFLOW_SANITIZE=ON", "-DSWELLFLOW_BENCHMARKS=OFF")


def required():
    return subprocess.run([str(ROOT / "tests" / "benchmarks" / "required"), str(caselib.program())], stdin=subprocess.DEVNULL).returncode


def fuzz():
    """As the test, but 2,000 inputs. One that was cut off goes on."""
    if not build("build-sanitize", "swellflow", *SANITIZED):
        return 1
    return subprocess.run([str(ROOT / "tests" / "robustness" / "fuzz.py"), "--program", str(ROOT / "build-sanitize" / "coupling" / "swellflow"), "--ordinary", str(caselib.program()),
                           "--inputs", "2000", "--jobs", str(os.cpu_count()), "--out", str(FOLDER / "fuzz")], stdin=subprocess.DEVNULL).returncode


def sanitizers():
    if not build("build-sanitize", "all", *SANITIZED):
        return 1
    environment = {**os.environ, "ASAN_OPTIONS": "detect_leaks=0", "UBSAN_OPTIONS": "print_stacktrace=1"}  # Open MPI itself leaks
    return subprocess.run(["ctest", "--output-on-failure", "-j", str(os.cpu_count()), "-L", "^(unit|verification|coupling)$"], cwd=ROOT / "build-sanitize", env=environment,
                          stdin=subprocess.DEVNULL).returncode


def valgrind():
    """For any processor: valgrind does not know the newest instructions."""
    options = ("-DCMAKE_BUILD_TYPE=Assert", "-DSWELLFLOW_NATIVE=OFF", "-DSWELLFLOW_BENCHMARKS=OFF")
    if not build("build-valgrind", "tests_sanitized", *options):
        return 1
    return subprocess.run([str(ROOT / "tests" / "valgrind.py"), str(ROOT / "build-valgrind")], stdin=subprocess.DEVNULL).returncode


PARTS = {
    "cavity_stiff": (cavity_stiff, "the paper's cavity with k_s = 1000, to t = 110"),
    "cavity_soft": (lambda: case("cavity_swelling", "cavity_soft", "--np", "2", "-var", "ks", "100", "--check"), "the paper's cavity with k_s = 100, to t = 110"),
    "hydrogel": (hydrogel, "the paper's bead over 9.7 hours, by both forms of its law"),
    "sedimentation": (sedimentation, "the paper's falling disc, cases A, B and C, rigid and soft, 100 and 200 cells"),
    "sedimentation_mesh": (sedimentation_mesh, "its case A with 100, 200 and 300 cells"),
    "density_ratios": (density_ratios, "a disc of density ratio 0.01 to 1000 comes to one velocity"),
    "elastic_ring": (elastic_ring, "an elastic ring that relaxes in creeping flow, against the closed form"),
    "capsule": (capsule, "a capsule in shear, Ca 0.01 to 0.1, against the boundary integral solution"),
    "flow_cavity": (flow_cavity, "lid-driven cavity, Re 10 to 1000, against published extrema"),
    "flow_channel": (flow_channel, "Poiseuille and Couette, driven in every way, along x and along y"),
    "flow_arrays": (flow_arrays, "creeping flow through square arrays of discs, with refinement and time steps"),
    "random_arrays": (random_arrays, "permeability of discs at random places, against the exact one of the same places"),
    "taylor_dispersion": (taylor_dispersion, "dye in a channel spreads at the exact rate"),
    "flow_stokes_channel": (flow_stokes_channel, "creeping flow around a cylinder between walls"),
    "shear_rotation": (shear_rotation, "free discs in creeping shear turn at the exact rate"),
    "couette_migration": (couette_migration, "a free disc in Couette flow follows the published path, 16 and 32 cells across it"),
    "close_contact": (close_contact, "discs pushed towards a wall and each other in creeping flow"),
    "flow_schaefer_turek": (flow_schaefer_turek, "benchmark 2D-1, 100 cells across the cylinder"),
    "flow_cylinder_steady": (flow_cylinder_steady, "cylinder in a stream, Re 20 and 40"),
    "flow_cylinder_shedding": (flow_cylinder_shedding, "cylinder in a stream, Re 100, 32 cells across it"),
    "tradeoff": (lambda: case("tradeoff", "tradeoff", "--check"), "the presets of the command accuracy keep what they promise, and lie on the front of Pareto"),
    "extremes": (lambda: case("extremes", "extremes", "--check"), "two discs at the edges of what may be asked for, one by one and in pairs: right, or refused, and never wrong"),
    "swelling_bed": (lambda: case("swelling_bed", "swelling_bed", "--np", "2", "--check"), "2,000 hydrogel beads swell where fresh water reaches them, and choke its way"),
    "swelling_bed_gap": (swelling_bed_gap, "100 of them, with hydraulic gaps of one to three cells, and without swelling"),
    "swelling_clock": (swelling_clock, "a faster clock of swelling leaves results as they are within what its measures promise"),
    "decomposition": (decomposition, "objects that cross, touch and rub end alike on every grid of 1 to 4 ranks, by each integrator"),
    "kills": (kills, "a run that is killed 200 times ends as the unbroken one, to the last bit"),
    "continued": (continued, "a run that goes on from a restart file equals the unbroken one, from and to 1, 2, 3 and 4 ranks"),
    "required": (required, "scenes with parts left out need less time and memory, and none of ours those of liggghts"),
    "fuzz": (fuzz, "2,000 spoilt scripts, tables and restart files end in a clean error or a valid run, with sanitizers"),
    "sanitizers": (sanitizers, "the tests, and cases in a short form, with address and undefined-behaviour sanitizers"),
    "valgrind": (valgrind, "the unit tests and coupled runs under memcheck, on 1 and 2 ranks"),
    "package": (package, "the .deb is installed by apt in a bare Debian 12, runs cases there, and is removed"),
}


# What else decides what a part finds
MORE_SOURCES = {"required": ("tests/benchmarks",), "fuzz": ("tests/robustness",), "sanitizers": ("tests",), "valgrind": ("tests",)}


def fingerprint(name):
    digest = hashlib.sha256()
    for source in SOURCES + MORE_SOURCES.get(name, ()):
        path = ROOT / source
        files = sorted(file for file in path.rglob("*") if file.is_file() and "__pycache__" not in file.parts) if path.is_dir() else [path]
        for file in files:
            digest.update(str(file.relative_to(ROOT)).encode() + b"\0" + file.read_bytes())
    return digest.hexdigest()


def verify(name):
    """True when the part holds for these sources."""
    run, words = PARTS[name]
    now = fingerprint(name)
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
    failed = [name for name in names or PARTS if not verify(name)]
    print(f"{len(names or PARTS) - len(failed)} passed, {len(failed)} failed")
    sys.exit(1 if failed else 0)


if __name__ == "__main__":
    main(sys.argv[1:])
