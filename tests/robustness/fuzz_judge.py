"""Runs the program on one spoilt input and says what became of it.

Good ends are `refused` (one error message, exit code not 0), `ran` (exit code 0, no NaN in thermo lines, tables and frames) and `long`: it was still running at the time limit and ended in order
on the signal that asks for it; and with sanitizers `memory`, when it asked for more in one piece than they can refuse. A fault of LIGGGHTS itself that is listed in fuzz_liggghts.py is named after it. All else is a fault of ours.
"""

import os
import re
import resource
import signal
import subprocess
import threading
from pathlib import Path

import numpy as np

import caselib
import fuzz_liggghts

MEMORY = 4 * 2**30  # bytes a rank: of addresses, and with sanitizers, which reserve addresses by the terabyte, of what is used
SANITIZERS = re.compile(r"AddressSanitizer|LeakSanitizer|runtime error:|__ubsan")
CRASHES = re.compile(r"Segmentation|exited on signal|terminate called|Assertion .* failed|Aborted|\*\*\* stack smashing|_GLIBCXX_ASSERTIONS")
TOO_MUCH_AT_ONCE = re.compile(r"AddressSanitizer: (allocator is out of memory|requested allocation size)|hard rss limit exhausted")
REFUSED_MEMORY = re.compile(r".*WARNING: AddressSanitizer failed to allocate.*\n")  # as malloc does; what the program makes of it counts
NOT_OURS = re.compile(r"\bstd::|vector::|basic_string|bad_alloc|_M_|stod|stoi|\bmap::at\b")
reading_frames = threading.Lock()


class Verdict:
    def __init__(self, word, detail=""):
        self.word, self.detail = word, detail[:250]

    @property
    def good(self):
        return self.word != "fault"

    @property
    def unsure(self):
        """Whether a program without sanitizers, which is faster and can refuse what it asks for in one piece, has to decide."""
        return self.word == "memory" or self.detail.startswith("hangs")

    def __str__(self):
        return f"{self.word}: {self.detail}" if self.detail else self.word


def sanitized(program):
    return b"__asan_init" in Path(program).read_bytes()


class Judge:
    def __init__(self, program, limit=30):
        self.program, self.limit = Path(program).absolute(), limit
        self.sanitized = sanitized(program)

    def environment(self, place):
        options = f"hard_rss_limit_mb={MEMORY >> 20}:max_allocation_size_mb={MEMORY >> 20}:allocator_may_return_null=1:detect_leaks=0:handle_abort=1:exitcode=99"
        return {**caselib.mpi_environment(grace=0), "TMPDIR": str(place / "tmp"), "HOME": str(place / "home"), "ASAN_OPTIONS": options, "UBSAN_OPTIONS": "print_stacktrace=1:halt_on_error=1"}

    def limits(self):
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
        if not self.sanitized:
            resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))

    def run(self, place, ranks):
        """Runs place/run/in.script; exit code, whether it was stopped for its time, whether it heard that, and what it said."""
        for name in ("tmp", "home"):
            (place / name).mkdir()
        (place / "beside").write_text("untouched")
        environment = self.environment(place)
        if ranks == 1:
            environment["OMPI_MCA_ess_singleton_isolated"] = "1"  # no daemon beside a single rank: it starts sooner, and says itself what is wrong
        command = ["mpirun", "--oversubscribe", "-np", str(ranks)] * (ranks > 1) + [str(self.program), "-echo", "both", "-in", "in.script"]
        stopped = heard = False
        with open(place / "screen", "wb") as screen:
            process = subprocess.Popen(command, cwd=place / "run", env=environment, stdin=subprocess.DEVNULL, stdout=screen, stderr=subprocess.STDOUT,
                                       start_new_session=True, preexec_fn=self.limits)
            try:
                process.wait(self.limit)
            except subprocess.TimeoutExpired:
                stopped = True
                heard = end(process, self.limit)
        return process.returncode, stopped, heard, REFUSED_MEMORY.sub("", (place / "screen").read_text(errors="replace"))

    def __call__(self, place, ranks):
        inputs = {path.name for path in (place / "run").iterdir()}
        code, stopped, heard, screen = self.run(place, ranks)
        verdict = self.verdict(place, inputs, code, stopped, heard, screen)
        if not verdict.good:
            known = fuzz_liggghts.reason(screen)
            if known:
                return Verdict("liggghts", known)
        return verdict

    def verdict(self, place, inputs, code, stopped, heard, screen):
        if TOO_MUCH_AT_ONCE.search(screen):
            return Verdict("memory")
        if SANITIZERS.search(screen):
            return Verdict("fault", "sanitizer: " + next(line for line in screen.splitlines() if SANITIZERS.search(line)).strip())
        if CRASHES.search(screen) or code < 0 and not stopped:
            return Verdict("fault", f"crashes, exit code {code}")
        if stopped and not heard:
            return Verdict("fault", f"hangs after '{fuzz_liggghts.last_command(screen)}'")
        outside = strangers(place)
        if outside:
            return Verdict("fault", f"writes outside its folder: {outside}")
        errors = [line for line in screen.splitlines() if line.startswith("ERROR")]
        if code != 0:
            return refusal(errors, screen)
        if errors:
            return Verdict("fault", f"an error and exit code 0: {errors[0]}")
        no_number = not_a_number(place / "run", inputs)
        if no_number:
            return Verdict("fault", f"NaN in {no_number} and exit code 0")
        return Verdict("long" if stopped else "ran")


def end(process, patience):
    """Asks the program to end as its documentation says; whether it did. What does not is killed, ranks with it."""
    process.send_signal(signal.SIGUSR2)
    try:
        process.wait(patience)
        return True
    except subprocess.TimeoutExpired:
        process.terminate()
    try:
        process.wait(10)
    except subprocess.TimeoutExpired:
        os.killpg(process.pid, signal.SIGKILL)
        process.wait()
    return False


def refusal(errors, screen):
    together = [line for line in errors if not line.startswith("ERROR on proc")]
    if not errors:
        return Verdict("fault", "ends without a message")
    if len(together) > 1:
        return Verdict("fault", f"{len(together)} messages: {together[0][:200]}")
    if NOT_OURS.search(errors[0]):
        return Verdict("fault", f"a message that says nothing to a user: {errors[0][:200]}")
    return Verdict("refused", errors[0][:200])


def strangers(place):
    """What stands beside the run's folder and was not put there."""
    names = {path.name for path in place.iterdir()} - {"run", "tmp", "home", "beside", "screen"}
    if (place / "beside").read_text() != "untouched":
        names.add("beside")
    return sorted(names)


def not_a_number(folder, inputs):
    """A result with a NaN in it, or None."""
    log = folder / "log.liggghts"
    if log.exists() and any(value != value for row in caselib.read_thermo(log) for value in row.values()):
        return "thermo lines"
    for path in sorted(folder.rglob("*.csv")):
        if path.is_file() and path.name not in inputs and re.search(rb"\bnan\b", path.read_bytes(), re.I):
            return path.name
    with reading_frames:
        return next((path.name for path in sorted(folder.rglob("*.vt[ip]")) if path.is_file() and not frame_is_finite(path)), None)


def frame_is_finite(path):
    import frames
    data = frames.read(path)
    values = [*frames.arrays(data.GetPointData()).values(), *frames.arrays(data.GetCellData()).values()]
    return all(np.isfinite(array).all() for array in values)
