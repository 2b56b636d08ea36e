"""Runs that are ended by signals or killed go on from their newest complete restart file as if nothing had happened.

SWELLFLOW_KILLS=N kills N times instead of 30, and SWELLFLOW_SEED=S draws other moments.
"""

import os
import random
import re
import signal
import subprocess
import sys
import time
import unittest
from pathlib import Path

import numpy as np

import caselib
import frames
import scene
from program import ProgramTest

KILLS = int(os.environ.get("SWELLFLOW_KILLS", 30))
SEED = int(os.environ.get("SWELLFLOW_SEED", random.randrange(10**6)))
STEPS, FRAME, SAVE = 1600, 40, 20
ROUNDING = 1e-9

# Sixteen objects that swell until they touch and are pressed flat, in a periodic box
BASE = {
    "boundary": "boundary p p p",
    "contact": scene.LINES["contact"].replace("gamman_abs peratomtypepair 1 0", "gamman_abs peratomtypepair 1 1"),
    "springs": "fix springs all mass_spring stiffness 2000 restitution 0.9",
    "swell": "fix grow all swell linear rate 0.1 max 0.27",
    "fluid": "fix water all fluid/ib cells 32 32 density 1000 viscosity 1e-2 every 2 body_force 0.3 0.1",
    "output": f"fix out all output/vtk every {FRAME} folder post fields velocity pressure objects outline\n"
              f"fix shape all output/objects every {FRAME} file objects.csv",
    "thermo": "thermo_style custom step time ke\nthermo 1000",
    "timestep": "timestep 1e-3",
}
# mpirun passes SIGTERM on after the grace time, and the run has to last until then.
LONGER = BASE["fluid"].replace("32 32", "192 192")
OBJECTS = "create_objects lattice 4 4 origin 0.125 0.125 spacing 0.25 disk diameter 0.22 points 20 density 1500 cds 0.1 reach 0"
END = "\ndump end all custom 1 end.dump id x y vx vy mass radius\ndump_modify end sort id format \"%d %.17g %.17g %.17g %.17g %.17g %.17g\"\nrun 0\n"

# mpirun tells the exit code of one rank only; this one notes its own, and sends no signal on: they go to the program.
RANK = """
import os, signal, subprocess, sys
for which in (signal.SIGTERM, signal.SIGINT, signal.SIGUSR1, signal.SIGUSR2):
    signal.signal(which, lambda *_: None)
rank = os.environ["OMPI_COMM_WORLD_RANK"]
program = subprocess.Popen(sys.argv[1:])
with open(f"pid.{rank}.part", "w") as file:
    file.write(str(program.pid))
os.rename(f"pid.{rank}.part", f"pid.{rank}")
code = program.wait()
with open(f"code.{rank}", "w") as file:
    file.write(str(code))
sys.exit(code)
"""


def script(resume, every=SAVE, behind="", **changes):
    lines = {**BASE, **changes}
    made = {"region": "", "box": "read_restart state.*", "objects": ""} if resume else {"objects": OBJECTS}
    return scene.scene(**{**lines, **made}, run=f"restart {every} state.*\nrun {STEPS} upto\nrestart 0{END}{behind}")


def saved_steps(folder):
    return sorted(int(file.suffix[1:]) for file in folder.glob("state.*") if file.suffix[1:].isdigit())


class KillsTest(ProgramTest):
    timeout = 120

    def start(self, text, ranks, name, grace=0):
        """Does not wait. A folder may hold what a run before left."""
        folder = self.folder(name)
        for old in [*folder.glob("pid.*"), *folder.glob("code.*")]:
            old.unlink()
        (folder / "in.script").write_text(text)
        (folder / "rank.py").write_text(RANK)
        command = ["mpirun", "--oversubscribe", "-np", str(ranks), sys.executable, "rank.py", str(caselib.program()), "-in", "in.script"]
        with open(folder / "screen", "w") as screen:
            process = subprocess.Popen(command, cwd=folder, env=caselib.mpi_environment(grace), stdin=subprocess.DEVNULL, stdout=screen, stderr=subprocess.STDOUT)
        self.addCleanup(process.kill)
        return folder, process

    def wait_for(self, condition, process):
        until = time.monotonic() + self.timeout
        while not condition():
            self.assertLess(time.monotonic(), until, "it hangs")
            if process.poll() is not None:
                return
            time.sleep(0.002)

    def processes(self, folder, ranks, process):
        self.wait_for(lambda: all((folder / f"pid.{rank}").exists() for rank in range(ranks)), process)
        return [int((folder / f"pid.{rank}").read_text()) for rank in range(ranks)]

    def finish(self, text, ranks, name):
        folder, process = self.start(text, ranks, name)
        self.assertEqual(process.wait(self.timeout), 0, (folder / "screen").read_text()[-2000:])
        return folder

    def end_of(self, folder):
        return np.loadtxt(folder / "end.dump", skiprows=9)


class Signals(KillsTest):
    def stopped(self, which, target, ranks, fluid):
        """The folder of a run that a signal ended, and its last step."""
        name = f"{target}{ranks}{which.name}"
        folder, process = self.start(script(False, behind="print 'the next command'\n", fluid=fluid), ranks, name, grace=2)
        pids = self.processes(folder, ranks, process)
        self.wait_for(lambda: len(saved_steps(folder)) >= 3, process)
        before = saved_steps(folder)[-1]
        for pid in {"one rank": pids[-1:], "all ranks": pids, "mpirun": [process.pid]}[target]:
            os.kill(pid, which)
        status = process.wait(self.timeout)
        codes = [(folder / f"code.{rank}").read_text() for rank in range(ranks)]
        self.assertEqual(codes, ["0"] * ranks, f"{name}: {(folder / 'screen').read_text()[-1000:]}")
        self.assertEqual(status, 1 if target == "mpirun" and which != signal.SIGUSR2 else 0, name)
        log = (folder / "log.liggghts").read_text()
        self.assertNotIn("the next command", log[-2000:])
        announced, step, file = re.search(r"the run ends after step (\d+)\n(?:.*\n)*Stopped by a signal at step (\d+); restart file: (\S+)", log).groups()
        self.assertEqual(announced, step)
        self.assertGreaterEqual(int(step), before)
        self.assertTrue((folder / file).exists())
        return folder, int(step)

    def test_the_run_goes_on_as_if_it_had_not_been_ended(self):
        for ranks, fluid, cases in ((1, LONGER, (("one rank", signal.SIGTERM), ("mpirun", signal.SIGINT))),
                                    (2, LONGER, (("one rank", signal.SIGINT), ("all ranks", signal.SIGTERM))),
                                    (4, BASE["fluid"], (("one rank", signal.SIGTERM), ("mpirun", signal.SIGUSR2)))):
            expected = self.end_of(self.finish(script(False, fluid=fluid), ranks, f"whole{ranks}"))
            for target, which in cases:
                with self.subTest(target, signal=which.name, ranks=ranks):
                    folder, step = self.stopped(which, target, ranks, fluid)
                    self.assertLess(step, STEPS, "the signal came too late")
                    self.finish(script(True, fluid=fluid), ranks, folder.name)
                    difference = np.abs(self.end_of(folder) - expected).max()
                    self.assertLess(difference, ROUNDING)

    def test_between_two_runs_the_fluid_step_under_way_is_the_last(self):
        for ranks in (1, 2):
            text = script(False, behind="print 'the next command'\n").replace(f"run {STEPS} upto", f"run 107\nshell kill -TERM `cat pid.0`\nrun {STEPS} upto")
            log = (self.finish(text, ranks, f"step{ranks}") / "log.liggghts").read_text()
            self.assertIn("Stopped by a signal at step 108; restart file: state.108", log)

    def test_a_second_signal_ends_at_once(self):
        folder, process = self.start(script(False), 2, "second")
        pids = self.processes(folder, 2, process)
        self.wait_for(lambda: len(saved_steps(folder)) >= 3, process)
        os.kill(pids[0], signal.SIGSTOP)  # the other rank waits for it, and cannot save
        os.kill(pids[1], signal.SIGTERM)
        time.sleep(0.7)
        os.kill(pids[1], signal.SIGTERM)
        self.wait_for((folder / "code.1").exists, process)
        self.assertEqual((folder / "code.1").read_text(), "1")
        os.kill(pids[0], signal.SIGKILL)
        self.assertNotEqual(process.wait(self.timeout), 0)
        self.assertNotIn("Stopped by a signal", (folder / "log.liggghts").read_text())
        last = saved_steps(folder)[-1]
        again = self.finish(script(True), 2, "second")
        self.assertIn(f"state.{last}: complete", (again / "log.liggghts").read_text())


class Runner(KillsTest):
    case = "cavity_swelling"

    def start_case(self, folder, *words):
        return subprocess.Popen([str(caselib.CASES / "run"), self.case, "--out", str(folder), *words], stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)

    def test_signals_and_resume(self):
        variables = ["-var", "t_end", "3", "-var", "t_save", "0.1", "-var", "t_history", "0.1", "-var", "t_frame", "0.2", "-var", "cells", "80"]
        whole, ended = self.folder("whole"), self.folder("ended")
        unbroken = self.start_case(whole, *variables, "--np", "2")
        unbroken.communicate(timeout=self.timeout)
        self.assertEqual(unbroken.returncode, 0)
        words = [*variables, "--np", "2"]
        for which in (signal.SIGTERM, signal.SIGINT, None):
            process = self.start_case(ended, *words)
            before = len(saved_steps(ended))
            if which:
                self.wait_for(lambda: len(saved_steps(ended)) > before + 2, process)
                process.send_signal(which)
            output, _ = process.communicate(timeout=self.timeout)
            self.assertEqual(process.returncode, 75 if which else 0, output[-2000:])
            self.assertEqual("--resume" in output.splitlines()[-1], which is not None)
            words = ["--resume"]
        for column in ("time", "natural_diameter", "area_diameter"):
            ours, theirs = (np.array([row[column] for row in caselib.read_csv(each / "history.csv")]) for each in (ended, whole))
            np.testing.assert_allclose(ours, theirs, rtol=1e-6)
        ours, theirs = (frames.Series(each / "post", "outline").frames for each in (ended, whole))
        np.testing.assert_allclose([time for time, _ in ours], [time for time, _ in theirs], rtol=1e-9)

    def test_a_second_signal_ends_at_once(self):
        folder = self.folder("second")
        process = self.start_case(folder, "-var", "t_save", "0.05", "--np", "2")
        self.wait_for(lambda: len(saved_steps(folder)) > 2, process)
        [mpirun] = map(int, Path(f"/proc/{process.pid}/task/{process.pid}/children").read_text().split())
        ranks = list(map(int, Path(f"/proc/{mpirun}/task/{mpirun}/children").read_text().split()))
        os.kill(ranks[0], signal.SIGSTOP)
        process.send_signal(signal.SIGTERM)
        time.sleep(0.8)
        process.send_signal(signal.SIGTERM)
        process.communicate(timeout=20)
        self.assertEqual(process.returncode, 128 + signal.SIGTERM)

    def test_what_cannot_go_on(self):
        for words, reason in (((), "has no run to go on with"), (("-var", "ks", "3"), "leave out -var")):
            process = self.start_case(self.folder("none"), "--resume", *words)
            output, _ = process.communicate(timeout=self.timeout)
            self.assertEqual(process.returncode, 1)
            self.assertIn(reason, output)


class Kills(KillsTest):
    def kill_once(self, ranks, draw, name):
        """Goes on with the run in the folder, and kills it. Whether that came in time."""
        folder = self.folder(name)
        known = saved_steps(folder)
        _, process = self.start(script(bool(known)), ranks, name)
        pids = self.processes(folder, ranks, process)
        self.wait_for(lambda: len(saved_steps(folder)) > len(known), process)
        if draw.random() < 0.5:
            time.sleep(draw.uniform(0.0, 0.1))
        else:  # while a file is being written
            self.wait_for(lambda: any(folder.glob("*.writing")), process)
        for pid in pids:
            try:
                os.kill(pid, signal.SIGKILL)
            except ProcessLookupError:
                pass
        in_time = process.wait(self.timeout) != 0
        if known:
            self.assertIn(f"state.{known[-1]}: complete", (folder / "screen").read_text())
        return in_time

    def assert_as_unbroken(self, folder, expected):
        for file in ("end.dump", "objects.csv"):
            self.assertEqual((folder / file).read_bytes(), (expected / file).read_bytes(), file)
        for name in ("outline", "fields"):
            ours, theirs = (frames.Series(each / "post", name).frames for each in (folder, expected))
            self.assertEqual([time for time, _ in ours], [time for time, _ in theirs])
            self.assertEqual(len(ours), STEPS // FRAME + 1)
            for (_, one), (_, other) in zip(ours, theirs):
                a, b = frames.read(one), frames.read(other)
                self.assertEqual(a.GetNumberOfPoints(), b.GetNumberOfPoints())
                for field, values in frames.arrays(a.GetCellData()).items():
                    np.testing.assert_array_equal(values, frames.arrays(b.GetCellData())[field], field)

    def kill_often(self, ranks, kills):
        print(f"seed {SEED}, {kills} kills, {ranks} rank(s)", flush=True)
        draw = random.Random(SEED + ranks)
        expected = self.finish(script(False), ranks, f"unbroken{ranks}")
        done = whole = cut_short = 0
        while done < kills:
            name = f"killed{ranks}.{whole}"
            if self.kill_once(ranks, draw, name):
                done += 1
                cut_short += any(self.folder(name).glob("*.writing"))
                if done < kills:
                    continue
                self.finish(script(True), ranks, name)
            self.assert_as_unbroken(self.folder(name), expected)
            whole += 1
        print(f"{whole} run(s) in pieces, {cut_short} kill(s) left a file that was being written", flush=True)

    def test_one_rank(self):
        self.kill_often(1, KILLS // 2)

    def test_two_ranks(self):
        self.kill_often(2, KILLS - KILLS // 2)


if __name__ == "__main__":
    unittest.main()
