"""What cases/study.py promises for any study: points are run once, a point that fails is a line like others, a study that is stopped goes on."""

import contextlib
import io
import json
import signal
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

import caselib
import study

SCRIPT = """
import json, sys
import study
this = study.Study(sys.argv[1], at_once=2)
def measure(outcome, others):
    if not outcome.finished:
        return {"verdict": outcome.status.upper()}
    return {"error": others["first"].values["mean"] - 1 if others else 1.0, "mean": outcome.run().thermo()[-1]["Step"] + 1.0}
points = [study.Point(labels={"knob": "flow"}, **point) for point in json.loads(this.record.folder.joinpath("points.json").read_text())]
this.run(points, measure)
"""
QUICK = {"cells": 4, "t_end": 0.001}


class Studies(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory(prefix="swellflow_")
        self.addCleanup(scratch.cleanup)
        self.folder = Path(scratch.name)
        (self.folder / "study").write_text(SCRIPT)
        (self.folder / caselib.RUN_FILE).write_text(json.dumps({"case": "channel", "ranks": 1, "variables": {}, "given": {}}))

    def command(self, **points):
        (self.folder / "points.json").write_text(json.dumps([{"name": name, **point} for name, point in points.items()]))
        return [sys.executable, "-B", str(self.folder / "study"), str(self.folder)]

    def study(self, **points):
        result = subprocess.run(self.command(**points), stdin=subprocess.DEVNULL, capture_output=True, text=True, timeout=120)
        self.assertEqual(result.returncode, 0, result.stdout + result.stderr)
        return result.stdout, {row["point"]: row for row in study.read_table(self.folder)}

    def test_points_are_run_once(self):
        point = {"case": "channel", "variables": QUICK}
        said, rows = self.study(first=point, second={**point, "ranks": 2})
        self.assertIn("2 points, 0 of them finished before", said)
        self.assertRegex(said, r"2/2 \w+: finished, \d+\.\d s; \d:\d\d:\d\d so far, about 0:00:00 left")
        self.assertEqual(list(rows["second"]), ["point", "knob", "case", "ranks", "settings", "error", "mean", "wall", "cpu", "status", "message"])
        self.assertEqual([rows["second"][name] for name in ("knob", "ranks", "settings", "status", "message")], ["flow", 2, "cells=4 t_end=0.001", "finished", ""])
        self.assertGreater(rows["first"]["wall"], 0.0)
        self.assertGreater(rows["first"]["cpu"], 0.0)
        said, again = self.study(first=point, second={**point, "ranks": 2}, third={**point, "variables": {**QUICK, "cells": 6}})
        self.assertIn("3 points, 2 of them finished before", said)
        self.assertNotIn("running first", said)
        self.assertEqual([again[name] for name in rows], list(rows.values()))  # its wall time, too
        said, _ = self.study(first=point, second=point)
        self.assertIn("running second", said)  # on another number of ranks it is another point

    def test_another_program_has_other_points(self):
        point = {"case": "channel", "variables": QUICK}
        self.study(first=point)
        record = self.folder / "first" / study.RECORD
        record.write_text(record.read_text().replace('"program": "', '"program": "0'))
        self.assertIn("running first", self.study(first=point)[0])

    def test_a_point_that_fails_is_a_line(self):
        bad = {"case": "channel", "variables": {**QUICK, "cells": -4}}
        wrong = {"case": "channel", "variables": {"cell": 4}}
        slow = {"case": "cavity_swelling", "variables": {}, "timeout": 1}
        _, rows = self.study(first={"case": "channel", "variables": QUICK}, bad=bad, wrong=wrong, slow=slow)
        self.assertEqual([row["status"] for row in rows.values()], ["finished", "failed", "failed", "timeout"])
        self.assertRegex(rows["bad"]["message"], r"^ERROR.*'cells' must be")
        self.assertRegex(rows["wrong"]["message"], "no variable 'cell'")
        self.assertEqual(rows["slow"]["message"], "not done after 1 s")
        self.assertEqual([row["verdict"] for row in rows.values()], ["", "FAILED", "FAILED", "TIMEOUT"])
        self.assertEqual(rows["bad"]["error"], "")
        self.assertIn("4 points, 4 of them finished before", self.study(first={"case": "channel", "variables": QUICK}, bad=bad, wrong=wrong, slow=slow)[0])

    def test_of_repeats_the_cheapest_counts(self):
        self.assertEqual(self.repeated(3, [(study.FINISHED, "", 1.0, 0.3, 0), (study.FINISHED, "", 3.0, 0.2, 0), (study.FINISHED, "", 2.0, 0.4, 0)]), (study.FINISHED, 0.2))
        self.assertEqual(self.repeated(3, [(study.FINISHED, "", 1.0, 0.1, 0), (study.FAILED, "lost", 1.0, 0.2, 1)]), (study.FAILED, 0.2))

    def repeated(self, times, ends):
        """Status and CPU time of a point whose runs end like this, one after the other; all of them must have been asked for."""
        this, left = study.Study(self.folder), iter(ends)
        this.call = lambda *_: next(left)
        with contextlib.redirect_stdout(io.StringIO()):
            outcome = this.run_point(study.Point("first", "channel", QUICK, repeats=times))
        self.assertEqual(list(left), [])
        return outcome.status, outcome.cpu

    def test_what_cannot_be_measured_is_a_line(self):
        _, rows = self.study(other={"case": "channel", "variables": QUICK}, first={"case": "channel", "variables": QUICK})
        self.assertEqual(rows["first"]["status"], "not measured")
        self.assertRegex(rows["first"]["message"], "KeyError.*first")

    def test_a_study_that_is_stopped_goes_on(self):
        points = {"first": {"case": "channel", "variables": QUICK}, "long": {"case": "sedimentation", "variables": {"cells": 200, "t_frame": 100}}}
        process = subprocess.Popen(self.command(**points), stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        self.addCleanup(process.kill)
        self.wait_for(lambda: "Step" in self.log("long") and (self.folder / "first" / study.RECORD).exists())
        process.send_signal(signal.SIGTERM)
        said, _ = process.communicate(timeout=60)
        self.assertEqual(process.returncode, 128 + signal.SIGTERM)
        self.assertIn("stopped with 1 of 2 points", said)
        self.assertIn("Stopped by a signal", (self.folder / "long" / "log.liggghts").read_text())
        points["long"]["variables"]["t_end"] = 0.001
        said, rows = self.study(**points)
        self.assertIn("2 points, 1 of them finished before", said)
        self.assertEqual([row["status"] for row in rows.values()], ["finished", "finished"])

    def log(self, name):
        path = self.folder / f"{name}.log"
        return path.read_text(errors="replace") if path.exists() else ""

    def wait_for(self, holds):
        end = time.monotonic() + 60
        while not holds():
            self.assertLess(time.monotonic(), end, "nothing happened within a minute")
            time.sleep(0.05)


if __name__ == "__main__":
    unittest.main()
