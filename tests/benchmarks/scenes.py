"""Scenes that are timed beside each other, and how much memory they need."""

import re
import subprocess
import sys
import tempfile
from pathlib import Path

FOLDER = Path(__file__).resolve().parent
ROOT = FOLDER.parents[1]
sys.path.insert(0, str(ROOT / "cases"))
import caselib  # noqa: E402

REPEATS = 5  # of which the fastest counts
BED, SPHERES = FOLDER / "in.bed", FOLDER / "in.spheres"


def default_program():
    """That of ./bootstrap build."""
    return ROOT / "build" / "coupling" / "swellflow"


class Scene:
    def __init__(self, name, ranks=1, script=BED, program=None, **variables):
        self.name, self.ranks, self.script, self.program, self.variables = name, ranks, script, program, variables
        self.seconds = float("inf")  # of ten steps, which are a fluid step
        self.shares = {}             # of the time, by part, in whole per cent

    def words(self, program):
        return ["mpirun", "--oversubscribe", "-np", str(self.ranks), str(self.program or program), "-in", str(self.script), "-log", "log.scene",
                *(word for name, value in self.variables.items() for word in ("-var", name, *str(value).split()))]

    def run(self, program, folder):
        result = subprocess.run(self.words(program), cwd=folder, env=caselib.mpi_environment(), stdin=subprocess.DEVNULL, capture_output=True, text=True)
        loops = re.findall(r"Loop time of (\S+) on \d+ procs for (\d+) steps", result.stdout)
        if result.returncode or len(loops) != 2:
            sys.exit(f"{self.name}:\n" + result.stdout[-2000:] + result.stderr[-2000:])
        seconds, steps = map(float, loops[-1])
        self.seconds = min(self.seconds, seconds * 10 / steps)
        progress = re.findall(r"^Progress: 100.*left; (.*)$", result.stdout, re.M)
        self.shares = {name: int(share) for name, share in re.findall(r"(\w+) (\d+) %", progress[-1])} if progress else {}


def measure(program, scenes):
    """In turn, so that what else the machine does meets all alike."""
    with tempfile.TemporaryDirectory(prefix="swellflow_scenes_") as folder:
        for _ in range(REPEATS):
            for scene in scenes:
                scene.run(program, folder)


def memory(program, scene):
    """Bytes that one rank needs at most."""
    with tempfile.TemporaryDirectory(prefix="swellflow_scenes_") as folder:
        command = ["/usr/bin/python3", "-c", "import resource, subprocess, sys; code = subprocess.call(sys.argv[1:], stdout=sys.stderr); "
                   "print(resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss); sys.exit(code)", *scene.words(program)]
        result = subprocess.run(command, cwd=folder, env=caselib.mpi_environment(), stdin=subprocess.DEVNULL, capture_output=True, text=True)
        if result.returncode:
            sys.exit(f"{scene.name}:\n" + result.stderr[-2000:])
        return 1024 * int(result.stdout)
