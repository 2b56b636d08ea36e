#!/usr/bin/python3
"""Restart files that are damaged, cut short, foreign, or cannot be written; how runs go on from good ones is in test_continued.py."""

import subprocess
import unittest

import caselib
import scene
from continued import SCENES, resumed, whole
from program import ProgramTest


class Files(ProgramTest):
    LINES = SCENES["soft, swelling, periodic"]

    def setUp(self):
        super().setUp()
        self.made = self.succeed(whole(self.LINES, "write_restart good.0\nrun 2\nwrite_restart good.*"))
        self.file = self.made.folder / "good.2"
        self.data = self.file.read_bytes()

    def refused(self, words, file, **changes):
        result = self.run_program(resumed({**self.LINES, **changes}, file, "run 2"), ranks=2)
        self.assertNotEqual(result.status, 0)
        self.assertEqual(result.output.count("ERROR:"), 1, result.output[-1500:])
        for word in words:
            self.assertIn(word, result.output)

    def test_damaged(self):
        for at in (1000, len(self.data) // 2, len(self.data) - 10):
            with self.subTest(at):
                (self.made.folder / "bad").write_bytes(self.data[:at] + bytes([self.data[at] ^ 1]) + self.data[at + 1:])
                self.refused(["read_restart", "'bad'", "damaged"], "bad")

    def test_cut_short(self):
        for length in (300, len(self.data) // 3, len(self.data) - 1):
            with self.subTest(length):
                (self.made.folder / "bad").write_bytes(self.data[:length])
                self.refused(["read_restart", "'bad'", f"{length} bytes", "cut short"], "bad")

    def test_foreign(self):
        (self.made.folder / "bad").write_text("a text\n" * 100)
        self.refused(["'bad'", "no restart file"], "bad")
        self.refused(["'nothing'", "No such file"], "nothing")
        self.refused(["'per_rank.%'", "leave it out"], "per_rank.%")

    def test_of_another_fluid(self):
        self.refused(["fix water fluid/ib", "number of cells in x", "48 in the file", "64 here"], "good.2", fluid=self.LINES["fluid"].replace("48 48", "64 64"))

    def test_the_newest_that_is_whole(self):
        (self.made.folder / "good.3").write_bytes(self.data[:-100])
        (self.made.folder / "good.4.writing").write_bytes(self.data)
        result = self.succeed(resumed(self.LINES, "good.*", "run 2"), ranks=2)
        self.assertIn("'good.3' ends after", result.output)
        self.assertIn("good.2: complete, with a fluid", result.output)

    def test_a_file_of_liggghts_itself(self):
        box = "\n".join(scene.LINES[key] for key in ("units", "dimension", "atoms", "map", "boundary", "newton", "region", "box"))
        self.succeed(box + "\ncreate_atoms 1 single 0.5 0.5 0\nset group all density 1000 diameter 0.1\nwrite_restart stock.restart\n", program="liggghts")
        result = self.succeed("atom_modify map array\nread_restart stock.restart\nwrite_restart ours.restart\n")
        self.assertIn("no checksum, no fluid", result.output)
        self.succeed("atom_modify map array\nread_restart ours.restart\n", program="liggghts")


class Writing(ProgramTest):
    LINES = SCENES["soft, swelling, periodic"]

    def fails(self, run, words):
        result = self.run_program(whole(self.LINES, run), ranks=2)
        self.assertNotEqual(result.status, 0)
        for word in words:
            self.assertIn(word, result.output)
        return result

    def test_within_a_fluid_step(self):
        self.fails("restart 15 state.*\nrun 30", ["'restart 15' falls within one", "every 2", "multiple"])
        self.fails("run 15\nwrite_restart state", ["this run ends 1 of 2 DEM steps", "write_restart: restart files are written between fluid steps, but step 15", "multiple of 'every'"])

    def test_one_a_rank(self):
        self.fails("restart 10 state.%\nrun 10", ["'state.%.*'", "leave it out"])
        self.fails("write_restart state.%", ["'state.%'", "leave it out"])

    def test_folder_that_is_not_there(self):
        """Known when the run begins, long before a file is due."""
        result = self.fails("restart 1000000 gone/state.*\nrun 1000000", ["'gone/state.1000000", "No such file", "this run has written none before"])
        self.assertNotIn("Step", result.output)
        self.fails("restart 10 state.*\nrun 10\nrestart 0\nrestart 10 gone/state.*\nrun 10", ["'gone/state.20", "No such file", "last good one is 'state.10'"])

    def test_no_room(self):
        """Files may not be as large as this one would be; MPI's own are smaller."""
        script = whole({**self.LINES, "fluid": self.LINES["fluid"].replace("48 48", "400 400")}, "restart 2 state.*\nrun 4")
        self.folder("full").joinpath("in.script").write_text(script)
        command = f"ulimit -f 6000; exec {caselib.program()} -in in.script"
        done = subprocess.run(["bash", "-c", command], cwd=self.folder("full"), env=caselib.mpi_environment(grace=0), stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=60)
        output = done.stdout.decode(errors="replace")
        self.assertNotEqual(done.returncode, 0)
        self.assertIn("must be written in full", output)
        self.assertEqual(list(self.folder("full").glob("state*")), [])


if __name__ == "__main__":
    unittest.main(verbosity=2)
