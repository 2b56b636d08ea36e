"""The points of a finished study where they lie: by drive, integrator and what was changed, one axis or two."""

import itertools

import caselib
import judge
import points
import study


class Map:
    def __init__(self, folder):
        self.short = caselib.Run(folder).variables["short"] == 1
        self.rows = {row["point"]: row for row in study.read_table(folder)}

    def missing(self):
        return [scene.name for scene in points.scenes(self.short) if scene.name not in self.rows]

    def ending(self, drive, motion, changes):
        """None where an axis means nothing."""
        row = self.rows.get(points.Scene(drive, motion, changes).name)
        return row and row["ending"]

    def count(self, rows):
        endings = [row["ending"] for row in rows]
        return {ending: endings.count(ending) for ending in judge.ENDINGS}

    def of_axis(self, axis, pairs):
        """Rows in which it was changed, alone or with another."""
        return [row for row in self.rows.values() if bool(row["second"]) == pairs and any(row[key].startswith(axis + "=") for key in ("first", "second"))]

    def all_of(self, ending):
        return [row for row in self.rows.values() if row["ending"] == ending]


def ends(axis):
    return points.AXES[axis][0], points.AXES[axis][-1]


def values(axis):
    """All along an axis, that of the base among them."""
    return sorted({*points.AXES[axis], points.BASE[axis]})


def pairs_of_ends(axes):
    """(place, place, changes) of a matrix in which each axis has two lines."""
    lines = [(axis, end) for axis in axes for end in ends(axis)]
    for (i, (one, a)), (k, (other, b)) in itertools.combinations(enumerate(lines), 2):
        if one != other:
            yield i, k, {one: a, other: b}
