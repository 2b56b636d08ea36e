"""Runs a case, and its check once more on a run that was tampered with. Shared by the tests of cases in a short form."""

import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import caselib


class CaseTest(unittest.TestCase):
    TIMEOUT = 120  # seconds, of a run

    def setUp(self):
        scratch = tempfile.TemporaryDirectory(prefix="swellflow_")
        self.addCleanup(scratch.cleanup)
        self.folder = Path(scratch.name) / "run"

    def run_case(self, name, *words):
        return self.call(str(caselib.CASES / "run"), name, "--out", str(self.folder), *words)

    def check(self, name):
        """Of the run as it now lies in the folder."""
        return self.call(sys.executable, str(caselib.CASES / name / "check"), str(self.folder))

    def check_fails(self, name, message):
        result = self.check(name)
        self.assertEqual(result.returncode, 1, result.stdout + result.stderr)
        self.assertRegex(result.stdout, message)

    def call(self, *command):
        return subprocess.run(command, stdin=subprocess.DEVNULL, capture_output=True, text=True, timeout=self.TIMEOUT, env={**os.environ, "PYTHONDONTWRITEBYTECODE": "1"})
