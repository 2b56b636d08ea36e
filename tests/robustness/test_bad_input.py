"""Bad input ends before any step, on every number of ranks, with one message: rule, value, place and remedy.

A row is a name, the changed line of the scene and what the message must say, in this order: place, rule, value, remedy.
What shows during a run only ends in the same way.
"""

import re
import unittest
from concurrent.futures import ThreadPoolExecutor

import rows_of_fluids
import rows_of_objects
import rows_of_runs
import rows_of_scenes
from program import ProgramTest
from rows_of_fluids import fluid
from rows_of_objects import swell
from rows_of_runs import DURING_A_RUN, STAYS_ALLOWED
from scene import LINES, scene

ROWS = rows_of_scenes.ROWS + rows_of_fluids.ROWS + rows_of_objects.ROWS + rows_of_runs.TOO_MUCH_ROWS


class BadInput(ProgramTest):
    timeout = 30

    def run_row(self, row, ranks):
        name, change, _ = row
        return self.run_program(change if isinstance(change, str) else scene(**change), ranks=ranks, name=f"{name} {ranks}".replace(" ", "_"))

    def check(self, ranks, rows=ROWS, runs=False):
        """Two at a time: most of what a row takes is the start of its ranks."""
        with ThreadPoolExecutor(2) as pool:
            tasks = [pool.submit(self.run_row, row, ranks) for row in rows]
        for (name, _, words), task in zip(rows, tasks):
            with self.subTest(name, ranks=ranks):
                result = task.result()
                self.assertNotEqual(result.status, 0, "the run went on")
                self.assertNotRegex(result.output, "Segmentation|signal|terminate called|assert", "it crashed")
                self.assertEqual(bool(re.search(r"^ *Step ", result.output, re.M)), runs, "whether the run began")
                messages = [line for line in result.output.splitlines() if line.startswith("ERROR")]
                self.assertEqual(len(messages), 1, result.output[-1500:])
                self.assertNotIn("(/", messages[0], "where in the source, but not where that was built")
                for word in words:
                    self.assertIn(word, messages[0])

    def test_scene_itself_runs(self):
        for ranks in (1, 2):
            result = self.succeed(scene(), ranks=ranks)
            self.assertEqual(result.thermo()[-1]["Step"], 10)

    def test_each_row_on_1_rank(self):
        self.check(1)

    def test_each_row_on_2_ranks(self):
        self.check(2)

    def test_each_row_during_a_run_on_1_rank(self):
        self.check(1, DURING_A_RUN, runs=True)

    def test_each_row_during_a_run_on_2_ranks(self):
        self.check(2, DURING_A_RUN, runs=True)

    def test_a_flow_that_nothing_resists_is_warned_of(self):
        alone = {"objects": "", "springs": "", "swell": "", "move": "", "output": "", "contact": "", "pair": "", "thermo": ""}
        alone["region"] = LINES["region"].replace("-0.005 0.005", "-0.02 0.02")
        for boundary, words, expected in (("p p p", "body_force 0 1", 1), ("p f p", "pressure_drop 1 0 slip ylo slip yhi", 1), ("p f p", "pressure_drop 1 0", 0)):
            with self.subTest(words, boundary=boundary):
                result = self.succeed(scene(**{**alone, **fluid(words, boundary)}), ranks=2, name=f"free {boundary} {expected} {len(words)}".replace(" ", "_"))
                self.assertEqual(result.output.count("accelerates without bound"), expected)
        result = self.succeed(scene(**fluid("body_force 0 1", "p p p")), name="objects_resist")
        self.assertNotIn("accelerates", result.output)

    def test_a_jump_of_the_natural_size_is_warned_of(self):
        for law, expected in (("polynomial 0.21 until 1", 1), ("polynomial 0.201 until 1", 0), ("polynomial 1 until 1 gives ratio", 0)):
            with self.subTest(law):
                result = self.succeed(scene(**swell(law)), name=law.replace(" ", "_"))
                self.assertEqual(result.output.count("the natural diameter of object (molecule) 1 jumps by 5 %"), expected)
                self.assertEqual(result.output.count("jumps by"), expected)

    def test_what_stays_allowed(self):
        for name, change in STAYS_ALLOWED:
            for ranks in (1, 2):
                with self.subTest(name, ranks=ranks):
                    self.succeed(scene(**change), ranks=ranks, name=f"{name} {ranks}".replace(" ", "_"))


if __name__ == "__main__":
    unittest.main()
