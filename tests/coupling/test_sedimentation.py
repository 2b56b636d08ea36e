"""The cases sedimentation and density_ratio in a short, coarse form: what they tell on one rank and on two, by rigid and by soft objects."""

import sys
import unittest

import numpy as np

import caselib
from case_test import CaseTest

sys.path += [str(caselib.CASES / name) for name in ("sedimentation", "density_ratio")]
import fall  # noqa: E402
import motion  # noqa: E402


class Sedimentation(CaseTest):
    """With 50 cells across the box, 6 across the disc."""

    def fall(self, *words, **variables):
        self.run_case("sedimentation", *words, cells=50, t_frame=10, **variables)
        return fall.Fall(self.folder)

    def test_case_a_falls_as_published_and_comes_to_rest(self):
        run = self.fall(t_end=1.25)
        self.assertEqual(run.case_of_paper, "A")
        self.assertLess(abs(run.peak / 5.58 - 1.0), 0.03)
        times, speeds = run.speed_of_motion()
        off = [np.interp(row["t"], times, speeds) + row["v"] for row in run.reference if 0.05 <= row["t"] <= 0.7]
        self.assertLess(np.abs(off).max() / 5.58, 0.06)
        self.assertLess(run.history["momentum_error"].max(), 1e-12)
        self.assertLess(run.history["divergence"].max(), 1e-9)
        self.assertLess(np.abs(run.speed[run.time > 1.15]).max() / run.peak, 1e-3)
        self.assertLess(abs(run.gap[-1]), run.depth_at_rest())

    def test_soft_rigid_and_two_ranks_agree(self):
        rigid, two, soft = (self.fall(*words, t_end=0.3, **variables) for words, variables in
                            (((), {}), (("--np", "2"), {}), (("--np", "2"), {"integrator": "nve/cds implicit"})))
        self.assertLess(np.abs(two.history["y"] - rigid.history["y"]).max(), 1e-9)
        self.assertLess(np.abs(soft.history["vy"] - rigid.history["vy"]).max() / rigid.peak, 0.005)

    def test_case_c_lands_between(self):
        run = self.fall("--np", "2", growth=0.25, t_end=0.8)
        self.assertEqual(run.case_of_paper, "C")
        time, diameter = run.landed
        self.assertLess(abs(time - 0.66), 0.03)
        self.assertLess(abs(diameter - 0.415), 0.0075)


class DensityRatio(CaseTest):
    """With 8 cells across the disc, where drags are a few per cent off, and fewer fluid steps."""

    def motion(self, *words, **variables):
        self.run_case("density_ratio", *words, cells=8, frames=1, **variables)
        return motion.Motion(self.folder)

    def test_the_terminal_velocity_does_not_depend_on_the_density(self):
        terminal = {}
        for density in (0.5, 1, 2, 10):
            run = self.motion("--np", "2", density=density, steps_least=200, re=5)
            terminal[density] = run.terminal
            self.assertLess((np.maximum.accumulate(run.smooth) - run.smooth).max(), 0.02)
        for density, velocity in terminal.items():
            self.assertLess(abs(velocity / terminal[2] - 1.0), 0.03, density)

    def test_a_weightless_disc_stays(self):
        run = self.motion(density=1, pull=0, steps_least=100)
        self.assertLess(np.abs(run.reported).max(), 1e-10)


if __name__ == "__main__":
    unittest.main()
