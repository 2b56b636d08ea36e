"""Runs the program, or stock liggghts, on a script given as text. Shared by the tests that judge it from outside."""

import subprocess
import tempfile
import unittest
from pathlib import Path

import caselib


class Result:
    def __init__(self, folder, status, output):
        self.folder, self.status, self.output = folder, status, output
        log = folder / "log.liggghts"
        self.log = log.read_text(errors="replace") if log.exists() else ""

    def thermo(self):
        return caselib.read_thermo(self.folder / "log.liggghts")


class ProgramTest(unittest.TestCase):
    """Each run has a folder of its own; a run that hangs fails."""

    timeout = 60

    def setUp(self):
        self.assertIsNotNone(caselib.program(), "SWELLFLOW_PROGRAM must name the built program")
        self.scratch = tempfile.TemporaryDirectory(prefix="swellflow_")
        self.addCleanup(self.scratch.cleanup)

    def folder(self, name):
        path = Path(self.scratch.name) / name
        path.mkdir(parents=True, exist_ok=True)
        return path

    def run_program(self, script=None, *arguments, ranks=1, program=None, name="run", stdin=""):
        """`script` goes into in.script and is read with -in; without one the program reads `stdin`."""
        folder = self.folder(name)
        command = ["mpirun", "--oversubscribe", "-np", str(ranks), str(program or caselib.program())]
        if script is not None:
            (folder / "in.script").write_text(script)
            command += ["-in", "in.script"]
        process = subprocess.Popen(command + list(arguments), cwd=folder, env=caselib.mpi_environment(grace=0),
                                   stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        try:
            output, _ = process.communicate(stdin.encode(), timeout=self.timeout)
        except subprocess.TimeoutExpired:
            process.terminate()
            output, _ = process.communicate()
            self.fail(f"hangs on {ranks} rank(s) after:\n{output.decode(errors='replace')[-2000:]}")
        return Result(folder, process.returncode, output.decode(errors="replace"))

    def succeed(self, *arguments, **options):
        result = self.run_program(*arguments, **options)
        self.assertEqual(result.status, 0, result.output[-2000:])
        return result
