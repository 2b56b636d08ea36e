"""What the runner, the cases' checks and the tests share: where things are, how MPI is started, how results are read.

A check is a script cases/NAME/check that is called with the folder of a finished run:

    run = caselib.Run(sys.argv[1])
    table = caselib.Table()
    table.at_most("divergence", run.thermo()[-1]["water[3]"], 1e-10)
    table.finish("slip error", slip)
"""

import csv
import json
import os
import re
import subprocess
import sys
from pathlib import Path

CASES = Path(__file__).resolve().parent
INSTALLED = not (CASES.parent / "CMakeLists.txt").exists()  # as PREFIX/share/swellflow/cases, wherever PREFIX was moved; else beside the sources
RUN_FILE = "run.json"


def program():
    """The program that belongs to these cases, or None. SWELLFLOW_PROGRAM names another build."""
    own = CASES.parents[2] / "bin" / "swellflow" if INSTALLED else CASES.parent / "build" / "coupling" / "swellflow"
    path = Path(os.environ.get("SWELLFLOW_PROGRAM", own))
    return path if path.exists() else None


def results():
    """Where results go by default: where one works when installed, else beside the sources."""
    return (Path.cwd() if INSTALLED else CASES.parent) / "results"


def mpi_environment(grace=1):
    """Root may run; ranks may outnumber cores, so an idle one yields and none is bound. `grace`: the seconds that mpirun waits
    after an error, or a SIGTERM or SIGINT to itself, before it sends ranks SIGTERM, and again before it kills them; a SIGUSR2
    to mpirun leaves them their time."""
    return {**os.environ, "OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1",
            "OMPI_MCA_mpi_yield_when_idle": "1", "OMPI_MCA_hwloc_base_binding_policy": "none",
            "OMPI_MCA_btl_vader_single_copy_mechanism": "none", "OMPI_MCA_odls_base_sigkill_timeout": str(grace),
            "OMP_NUM_THREADS": "1"}


def case_names():
    return sorted(path.name for path in CASES.iterdir() if Case(path.name).script.exists())


class Case:
    """An input script of the program, in.NAME; or a study of many runs in Python, `study` (see study.py). NAME/SCENE is a scene that study NAME alone runs."""

    def __init__(self, name):
        self.name = name
        self.folder = CASES / name
        self.is_study = (self.folder / "study").exists()
        self.script = self.folder / ("study" if self.is_study else f"in.{self.folder.name}")

    def declared_variables(self):
        """What -var can set: {name: default}, in the script's order; a study's docstring has them as an input script does."""
        pattern = re.compile(r"^\s*variable\s+(\S+)\s+index\s+([^#\n]*)", re.M)
        return {name: default.strip() for name, default in pattern.findall(self.script.read_text())}

    def choices(self, variable):
        """The words that it may be, where the script jumps to a label that is named after it and its value; else none."""
        script = self.script.read_text()
        if f"jump SELF {variable}_${{{variable}}}" not in script:
            return []
        return [word for word in re.findall(rf"^\s*label\s+{variable}_(\S+)", script, re.M) if word != "known"]


def number(text):
    try:
        return float(text)
    except ValueError:
        return text


def read_csv(path):
    """Rows as dictionaries by column, numbers as floats; lines that start with # are left out."""
    with open(path) as file:
        return [{key: number(value) for key, value in row.items()}
                for row in csv.DictReader(line for line in file if not line.startswith("#"))]


def read_thermo(log):
    """All thermo rows of a log in order, as dictionaries by column. Needs `thermo_style custom` or one."""
    rows, columns = [], None
    for line in Path(log).read_text(errors="replace").splitlines():
        words = line.split()
        if words[:1] == ["Step"]:
            columns = words
        elif columns and len(words) == len(columns) and all(isinstance(number(word), float) for word in words):
            rows.append(dict(zip(columns, map(float, words))))
        elif line.startswith("Loop time"):
            columns = None
    return rows


class Run:
    """A finished run of a case: .folder, .case, .ranks, .variables (defaults and -var), .reference (rows of reference.csv)."""

    def __init__(self, folder):
        self.folder = Path(folder).absolute()
        record = json.loads((self.folder / RUN_FILE).read_text())
        self.case = Case(record["case"])
        self.ranks = record["ranks"]
        self.variables = {name: number(value) for name, value in record["variables"].items()}
        reference = self.case.folder / "reference.csv"
        self.reference = read_csv(reference) if reference.exists() else []

    def thermo(self):
        return read_thermo(self.folder / "log.liggghts")

    def again(self, name, **changes):
        """The same run with other variables, in the sub-folder `name`; what it prints is kept in NAME.log."""
        variables = json.loads((self.folder / RUN_FILE).read_text())["variables"]
        command = [sys.executable, str(CASES / "run"), self.case.name, "--np", str(self.ranks), "--out", str(self.folder / name)]
        for key, value in {**variables, **changes}.items():
            command += ["-var", key, f"{value}"]
        print(f"running {', '.join(f'{key} {value}' for key, value in changes.items())} for comparison …", flush=True)
        with open(self.folder / f"{name}.log", "w") as log:
            if subprocess.run(command, stdout=log, stderr=subprocess.STDOUT).returncode:
                sys.exit(f"that run failed: see {log.name}")
        return type(self)(self.folder / name)


class Table:
    """What a check found: one line a condition, then the figure; ends the script, non-zero when a condition failed."""

    def __init__(self):
        self.failed = 0
        self.compared = True

    def note(self, name, value):
        """A figure that is shown and not judged."""
        print(f"      {name}: {value:.6g}")

    def nothing_published(self, what):
        """No reference is at hand for these variables: only what every flow must keep is judged."""
        self.compared = False
        print(f"      {what}: no published value is at hand, the figures below are compared with nothing")

    def line(self, name, value, condition, good):
        self.failed += not good
        print(f"{'ok  ' if good else 'FAIL'}  {name}: {value:.6g}  ({condition})")

    def at_most(self, name, value, limit):
        self.line(name, value, f"at most {limit:g}", value <= limit)

    def at_least(self, name, value, limit):
        self.line(name, value, f"at least {limit:g}", value >= limit)

    def within(self, name, value, low, high):
        self.line(name, value, f"{low:g} to {high:g}", low <= value <= high)

    def near(self, name, value, expected, relative):
        self.within(name, value, expected - abs(expected) * relative, expected + abs(expected) * relative)

    def finish(self, name, value):
        verdict = f"{self.failed} of the conditions failed" if self.failed else "all conditions hold"
        verdict += "" if self.compared else ", but no published value was compared"
        print(f"{verdict}; {name} = {value:.6g}" if isinstance(value, float) else f"{verdict}; {name} = {value}")
        sys.exit(1 if self.failed else 0)
