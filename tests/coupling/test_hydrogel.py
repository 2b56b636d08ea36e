"""The hydrogel case in a short form: its check passes, on one rank and on several, and notices what is wrong."""

import subprocess
import unittest

import caselib
from case_test import CaseTest

SHORT = ("-var", "hours", "0.03")


class Hydrogel(CaseTest):
    def test_the_check_passes(self):
        for words in (("--np", "1"), ("--np", "2", "-var", "law", "reconstructed"), ("--np", "1", "-var", "points", "10")):
            with self.subTest(words):
                result = self.run_case("hydrogel", *SHORT, "--check", *words)
                self.assertEqual(result.returncode, 0, result.stdout[-2000:] + result.stderr[-2000:])
                self.assertRegex(result.stdout.splitlines()[-1], r"all conditions hold; diameter in mm at 0\.03\d* h = 3\.1")

    def fails_with(self, column, change, message):
        file = self.folder / "bead.csv"
        text = file.read_text()
        lines = [line.split(",") for line in text.splitlines()]
        place = next(k for k, name in enumerate(lines[0]) if name.startswith(column))
        lines[-3][place] = str(change(float(lines[-3][place])))
        file.write_text("\n".join(",".join(line) for line in lines) + "\n")
        result = self.check("hydrogel")
        file.write_text(text)
        self.assertEqual(result.returncode, 1, result.stdout + result.stderr)
        self.assertRegex(result.stdout + result.stderr, message)

    def test_the_check_notices_what_is_wrong(self):
        result = self.run_case("hydrogel", *SHORT)
        self.assertEqual(result.returncode, 0, result.stdout[-2000:] + result.stderr[-2000:])
        self.fails_with("mean_diameter", lambda D: 1.003 * D, "FAIL  diameter off the law")
        self.fails_with("mean_diameter", lambda D: 1.006 * D, "FAIL  difference from 10 points")
        self.fails_with("rotation", lambda angle: 2e-6, "FAIL  rotation")
        log = self.folder / "log.liggghts"
        log.write_text(log.read_text() + "fluid: prediction 60 %\n")
        self.assertRegex(self.check("hydrogel").stdout, "FAIL  times that the log speaks of a fluid")

    def test_a_fluid_would_call_fftw(self):
        """That the loader's words are what the check takes them for."""
        self.folder.mkdir()
        environment = {**caselib.mpi_environment(), "LD_DEBUG": "bindings", "LD_DEBUG_OUTPUT": str(self.folder / "bindings")}
        cavity = caselib.Case("cavity_swelling")
        subprocess.run([str(caselib.program()), "-in", str(cavity.script), "-var", "t_end", "0.001"], cwd=self.folder, env=environment,
                       stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, check=True, timeout=120)
        text = "".join(file.read_text(errors="replace") for file in self.folder.glob("bindings.*"))
        self.assertRegex(text, r"swellflow \[0\] to \S*libfftw\S* \[0\]: normal symbol `fftw_plan")


if __name__ == "__main__":
    unittest.main()
