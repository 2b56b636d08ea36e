"""Runs a case, and its check once more on a run that was tampered with. Shared by the tests of cases in a short form."""

import json
import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import caselib


class CaseTest(unittest.TestCase):
    """Each run has a folder of its own; `self.folder` and `self.case` are those of the last one."""

    TIMEOUT = 120  # seconds, of a run

    def setUp(self):
        scratch = tempfile.TemporaryDirectory(prefix="swellflow_")
        self.addCleanup(scratch.cleanup)
        self.scratch = Path(scratch.name)

    def run_case(self, name, *words, **variables):
        """What it says."""
        self.case, self.folder = name, Path(tempfile.mkdtemp(dir=self.scratch))
        given = [word for key, value in variables.items() for word in ("-var", key, str(value))]
        result = self.call(str(caselib.CASES / "run"), name, "--out", str(self.folder), *words, *given)
        self.assertEqual(result.returncode, 0, result.stdout[-3000:] + result.stderr[-2000:])
        return result.stdout

    def passes(self, figure, name, *words, **variables):
        """With its check, whose last line is judged, too."""
        said = self.run_case(name, "--check", *words, **variables)
        self.assertRegex(said.splitlines()[-1], "all conditions hold[^;]*; " + figure)
        return said

    def fails_with(self, edit, file, message):
        """The check of the last run, when a file of it were another: `edit` makes its text so. Afterwards it is as it was."""
        path = self.folder / file
        text = path.read_text()
        other = edit(text)
        self.assertNotEqual(other, text, f"{file} is as it was, so that the check cannot fail by it")
        path.write_text(other)
        result = self.call(sys.executable, str(caselib.CASES / self.case / "check"), str(self.folder))
        path.write_text(text)
        self.assertEqual(result.returncode, 1, result.stdout + result.stderr)
        self.assertRegex(result.stdout, message)

    def fails_with_column(self, column, change, message, file="history.csv", lines=slice(None)):
        """When what a column has in these lines were another."""
        def edit(text):
            titles, *rows = [line.split(",") for line in text.splitlines()]
            place = [title.partition(" [")[0] for title in titles].index(column)
            for row in rows[lines]:
                row[place] = repr(change(float(row[place])))
            return "\n".join(map(",".join, [titles, *rows])) + "\n"
        self.fails_with(edit, file, message)

    def fails_when_taken_for(self, message, **variables):
        """When the check is told of other values of variables than the run had."""
        def edit(text):
            record = json.loads(text)
            record["variables"].update((name, str(value)) for name, value in variables.items())
            return json.dumps(record)
        self.fails_with(edit, caselib.RUN_FILE, message)

    def call(self, *command):
        return subprocess.run(command, stdin=subprocess.DEVNULL, capture_output=True, text=True, timeout=self.TIMEOUT, env={**os.environ, "PYTHONDONTWRITEBYTECODE": "1"})
