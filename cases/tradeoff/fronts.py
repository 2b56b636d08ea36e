"""The rows of a finished study by what they set, fronts of Pareto, and how far presets are from them."""

import math
from dataclasses import dataclass

import caselib
import points
import presets
import scenes
import study


@dataclass
class Mark:
    """What counts of one setting: seconds and error."""
    cost: float
    error: float

    def beats(self, other):
        return self.cost < other.cost and self.error < other.error


class Results:
    def __init__(self, folder):
        self.short = caselib.Run(folder).variables["short"] == 1
        self.rows = {row["point"]: row for row in study.read_table(folder)}
        self.scenes = [scene for scene in scenes.SCENES if points.name_of(scene, scene.default) in self.rows]

    def row(self, scene, setting):
        return self.rows[points.name_of(scene, setting)]

    def mark(self, scene, setting):
        """None of a point that failed."""
        row = self.row(scene, setting)
        return Mark(row["cost"], row["error"]) if row["status"] == study.FINISHED else None

    def marks(self, scene):
        """All of a scene that finished."""
        found = (self.mark(scene, setting) for setting in points.settings(scene, self.short))
        return [mark for mark in found if mark]

    def preset(self, scene, name):
        return self.mark(scene, presets.in_scene(name, scene))

    def gridded(self):
        """The scenes that the grid and the presets are in."""
        return [scene for scene in self.scenes if points.has_presets(scene)]

    def overall(self):
        """Of each place of the grid the means over all scenes, where all finished."""
        return [mean for mean in (self.mean([self.mark(scene, points.grid(scene)[place]) for scene in self.gridded()]) for place in points.grid(self.gridded()[0])) if mean]

    def overall_preset(self, name):
        return self.mean([self.preset(scene, name) for scene in self.gridded()])

    def mean(self, marks):
        """Geometric, of cost and error, each over that of the scene's default."""
        if not all(marks):
            return None
        defaults = [self.mark(scene, scene.default) for scene in self.gridded()]
        return Mark(*(math.exp(sum(math.log(getattr(mark, name) / getattr(default, name)) for mark, default in zip(marks, defaults)) / len(marks)) for name in ("cost", "error")))


def front(marks):
    """Those that no other beats, by cost."""
    return sorted((mark for mark in marks if not any(other.beats(mark) for other in marks)), key=lambda mark: mark.cost)


def distance(mark, marks):
    """The factor by which another is cheaper and more exact at once, the smaller of both: 1 on the front."""
    return max([1.0, *(min(mark.cost / other.cost, mark.error / other.error) for other in marks)])
