"""What studies of many runs share: each point is a case with variables, run in a folder of its own; all together they make one CSV.

A study is a script cases/NAME/study in place of in.NAME. cases/run calls it with the folder for its results, and does not empty that folder:
points that are finished there, by this program and with these settings, are not run again. Its variables are declared in its docstring, one a line, as in
an input script, and -var sets them:

    variable short index 0    # 1: fewer points

    this = study.Study(sys.argv[1])
    this.run([study.Point("fine", "cylinder", {"cells": 32, "re": 20}), …], measure)

measure(outcome, others) gives what a point showed, as {column: value}; `others` has those before it, by name. A point that fails ends nothing: its line has its
status and message, and measure is asked about it like the others.
"""

import csv
import hashlib
import json
import os
import re
import shutil
import signal
import subprocess
import sys
import threading
import time
from concurrent.futures import ThreadPoolExecutor, as_completed
from dataclasses import asdict, dataclass, field

import caselib

RECORD, TABLE = "point.json", "points.csv"
FINISHED, FAILED, TIMEOUT, UNMEASURED = "finished", "failed", "timeout", "not measured"
OWN_COLUMNS = ("wall", "cpu", "status", "message")
GRACE = 10  # seconds that a point has to end after it was told
MISTAKE = re.compile(r"^(?:ERROR|swellflow|cases/run|swellflow-case)\b.*|^\w*Error: .*", re.M)


@dataclass
class Point:
    name: str                    # of its folder
    case: str
    variables: dict              # as -var sets them
    ranks: int = 1
    labels: dict = field(default_factory=dict)  # columns of the study's own, before the settings
    weight: float = 1.0          # what it costs beside others, for the time left
    timeout: float = 3600.0      # seconds
    discard: tuple = ()          # files and folders, as patterns, that measure does not need
    repeats: int = 1             # times that it is run, of which the one with the least CPU time counts: other work on the machine only adds to it


@dataclass
class Outcome:
    point: Point
    folder: object
    status: str                  # FINISHED, FAILED, TIMEOUT or UNMEASURED
    message: str = ""
    wall: float = 0.0            # seconds
    cpu: float = 0.0             # of user and system on all ranks, the start of the program included (about 0.2 s a rank)
    exit_code: int = 0
    values: dict = field(default_factory=dict)

    @property
    def finished(self):
        return self.status == FINISHED

    def run(self):
        return caselib.Run(self.folder)


class Stopped(Exception):
    """The study was told to end."""


def settings(point):
    """What makes two runs of a point the same."""
    program = hashlib.sha256(caselib.program().read_bytes()).hexdigest()
    script = hashlib.sha256(caselib.Case(point.case).script.read_bytes()).hexdigest()
    return {"case": point.case, "variables": {key: f"{value}" for key, value in point.variables.items()}, "ranks": point.ranks, "program": program, "script": script}


class Study:
    """`at_once` points run at the same time; their wall times are then worth little."""

    def __init__(self, folder, at_once=1):
        self.record = caselib.Run(folder)
        self.folder, self.variables, self.ranks = self.record.folder, self.record.variables, self.record.ranks
        self.at_once = at_once
        self.running, self.stopped = set(), None
        self.lock = threading.Lock()

    def run(self, points, measure):
        """Runs what is not there yet, measures all in the order of the points, and writes the table after each; the outcomes by name."""
        names = [point.name for point in points]
        assert len(names) == len(set(names)), "two points have one name"
        for which in (signal.SIGTERM, signal.SIGINT):
            signal.signal(which, self.stop)
        found = {point.name: self.found(point) for point in points}
        missing = [point for point in points if found[point.name] is None]
        print(f"{len(points)} points, {len(points) - len(missing)} of them finished before", flush=True)
        outcomes = {}
        try:
            self.measure_on(points, found, outcomes, measure)
            for outcome in self.run_all(missing):
                found[outcome.point.name] = outcome
                self.measure_on(points, found, outcomes, measure)
        except Stopped:
            print(f"stopped with {len(outcomes)} of {len(points)} points in {self.folder / TABLE}: the same command goes on", flush=True)
            sys.exit(128 + self.stopped)
        return outcomes

    def run_all(self, points):
        """Yields each as it ends."""
        progress = Progress(points)
        with ThreadPoolExecutor(self.at_once) as pool:
            tasks = [pool.submit(self.run_point, point) for point in points]
            for task in as_completed(tasks):
                outcome = task.result()
                progress.done(outcome)
                yield outcome

    def measure_on(self, points, found, outcomes, measure):
        """As far as points are there without a gap, since those may be compared with others before them."""
        before = len(outcomes)
        for point in points[before:]:
            outcome = found[point.name]
            if outcome is None:
                break
            try:
                outcome.values = measure(outcome, outcomes)
            except Exception as error:  # any: the point's files may hold anything
                outcome.status, outcome.message = UNMEASURED, "; ".join(filter(None, [outcome.message, f"{type(error).__name__}: {error}"]))
            outcomes[point.name] = outcome
        if len(outcomes) > before:
            write_table(self.folder / TABLE, outcomes.values())

    def found(self, point):
        """What a run before left, or None."""
        folder = self.folder / point.name
        try:
            record = json.loads((folder / RECORD).read_text())
        except (OSError, ValueError):
            return None
        return Outcome(point, folder, **record["outcome"]) if record["settings"] == settings(point) else None

    def run_point(self, point):
        if self.stopped:
            raise Stopped
        folder = self.folder / point.name
        if folder.exists():
            shutil.rmtree(folder)
        command = [sys.executable, str(caselib.CASES / "run"), point.case, "--np", str(point.ranks), "--out", str(folder)]
        for key, value in point.variables.items():
            command += ["-var", key, f"{value}"]
        print(f"running {point.name} …\n", end="", flush=True)  # in one piece, as others may speak at the same time
        log = self.folder / f"{point.name}.log"
        outcome = self.best(point, folder, command, log)
        for pattern in point.discard:
            for path in folder.glob(pattern):
                shutil.rmtree(path) if path.is_dir() else path.unlink()
        self.keep(outcome)
        return outcome

    def best(self, point, folder, command, log):
        """Of its repeats; the first that does not finish ends them, and counts."""
        outcomes = []
        while len(outcomes) < point.repeats and all(outcome.finished for outcome in outcomes):
            outcomes.append(Outcome(point, folder, *self.call(command, log, point.timeout)))
            if self.stopped:
                raise Stopped
        return min(outcomes, key=lambda outcome: (outcome.finished, outcome.cpu))

    def keep(self, outcome):
        record = {key: value for key, value in asdict(outcome).items() if key not in ("point", "folder", "values")}
        outcome.folder.mkdir(exist_ok=True)
        partial = outcome.folder / (RECORD + ".partial")
        partial.write_text(json.dumps({"settings": settings(outcome.point), "outcome": record}, indent=2) + "\n")
        partial.rename(outcome.folder / RECORD)

    def call(self, command, log, timeout):
        """Status, message, wall time, CPU time and exit code. wait4 counts the CPU time of all that the command has started and waited for."""
        start = time.monotonic()
        with open(log, "w") as file:
            process = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=file, stderr=subprocess.STDOUT, start_new_session=True)
        with self.lock:
            self.running.add(process)
        late, ended = threading.Event(), threading.Event()
        timer = threading.Timer(timeout, self.end, (process, late, ended))
        timer.start()
        _, status, usage = os.wait4(process.pid, 0)
        timer.cancel()
        with self.lock:
            self.running.discard(process)
        ended.set()
        process.returncode = os.waitstatus_to_exitcode(status)
        outcome = TIMEOUT if late.is_set() else FAILED if process.returncode else FINISHED
        message = {FINISHED: "", TIMEOUT: f"not done after {timeout:g} s", FAILED: complaint(log)}[outcome]
        return outcome, message, time.monotonic() - start, usage.ru_utime + usage.ru_stime, process.returncode

    def stop(self, which, _):
        """What a signal does: cases/run ends its point in order, and at once when it comes again."""
        self.stopped = which
        with self.lock:
            for process in self.running:
                os.kill(process.pid, signal.SIGTERM)

    def end(self, process, late, ended):
        """What took too long, and at last what does not hear."""
        late.set()
        for _ in range(3):  # in order, at once, by SIGKILL
            with self.lock:
                if process in self.running:
                    os.kill(process.pid, signal.SIGTERM)
            if ended.wait(GRACE):
                return


def complaint(log):
    """The first line of a log that names a mistake, else its last one."""
    text = log.read_text(errors="replace")
    match = MISTAKE.search(text)
    return match.group(0) if match else next((line for line in reversed(text.splitlines()) if line.strip()), "said nothing")


class Progress:
    def __init__(self, points):
        self.start, self.count, self.finished = time.monotonic(), len(points), 0
        self.weight, self.passed = sum(point.weight for point in points), 0.0

    def done(self, outcome):
        self.finished, self.passed = self.finished + 1, self.passed + outcome.point.weight
        spent = time.monotonic() - self.start
        left = spent * (self.weight - self.passed) / self.passed
        words = outcome.status if outcome.finished else f"{outcome.status}: {outcome.message}"
        print(f"{self.finished}/{self.count} {outcome.point.name}: {words}, {outcome.wall:.1f} s; {clock(spent)} so far, about {clock(left)} left", flush=True)


def clock(seconds):
    whole = round(seconds)
    return f"{whole // 3600}:{whole // 60 % 60:02d}:{whole % 60:02d}"


def write_table(path, outcomes):
    """One line a point: its name, its labels, its settings, what was measured, times and status."""
    outcomes = list(outcomes)
    columns = {key: None for outcome in outcomes for key in outcome.point.labels}
    columns |= {"case": None, "ranks": None, "settings": None}
    columns |= {key: None for outcome in outcomes for key in outcome.values}
    partial = path.with_suffix(".partial")
    with open(partial, "w", newline="") as file:
        out = csv.DictWriter(file, ["point", *columns, *OWN_COLUMNS], restval="")
        out.writeheader()
        for outcome in outcomes:
            point = outcome.point
            out.writerow({"point": point.name, **point.labels, "case": point.case, "ranks": point.ranks,
                          "settings": " ".join(f"{key}={value}" for key, value in point.variables.items()),
                          **{key: f"{value:.6g}" if isinstance(value, float) else value for key, value in outcome.values.items()},
                          "wall": f"{outcome.wall:.2f}", "cpu": f"{outcome.cpu:.2f}", "status": outcome.status, "message": outcome.message})
    partial.replace(path)


def read_table(folder):
    return caselib.read_csv(caselib.Run(folder).folder / TABLE)
