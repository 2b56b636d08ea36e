"""The hydrogel case in a short form: its check passes, on one rank and on several, and notices what is wrong."""

import subprocess
import unittest

import caselib
from case_test import CaseTest

SHORT = {"hours": 0.03}


class Hydrogel(CaseTest):
    def test_the_check_passes(self):
        for ranks, variables in (("1", {}), ("2", {"law": "reconstructed"}), ("1", {"points": 10})):
            with self.subTest(ranks=ranks, **variables):
                self.passes(r"diameter in mm at 0\.03\d* h = 3\.1", "hydrogel", "--np", ranks, **SHORT, **variables)

    def test_the_check_notices_what_is_wrong(self):
        self.run_case("hydrogel", **SHORT)
        once = {"file": "bead.csv", "lines": slice(-3, -2)}
        self.fails_with_column("mean_diameter", lambda D: 1.003 * D, "FAIL  diameter off the law", **once)
        self.fails_with_column("mean_diameter", lambda D: 1.006 * D, "FAIL  difference from 10 points", **once)
        self.fails_with_column("rotation", lambda angle: 2e-6, "FAIL  rotation", **once)
        self.fails_with(lambda text: text + "fluid: prediction 60 %\n", "log.liggghts", "FAIL  times that the log speaks of a fluid")

    def test_a_fluid_would_call_fftw(self):
        """That the loader's words are what the check takes them for."""
        environment = {**caselib.mpi_environment(), "LD_DEBUG": "bindings", "LD_DEBUG_OUTPUT": str(self.scratch / "bindings")}
        cavity = caselib.Case("cavity_swelling")
        subprocess.run([str(caselib.program()), "-in", str(cavity.script), "-var", "t_end", "0.001"], cwd=self.scratch, env=environment,
                       stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, check=True, timeout=120)
        text = "".join(file.read_text(errors="replace") for file in self.scratch.glob("bindings.*"))
        self.assertRegex(text, r"swellflow \[0\] to \S*libfftw\S* \[0\]: normal symbol `fftw_plan")


if __name__ == "__main__":
    unittest.main()
