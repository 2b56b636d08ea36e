"""The numbers of a run of the cylinder: drag, lift, Strouhal number and wake."""

import drag
import fields
import frames
import histories

SHEDS_ABOVE = 47.0  # Reynolds number


class Stream:
    def __init__(self, run):
        self.run, self.history, self.last = run, histories.History(run), fields.last(run)
        self.outline = frames.outlines(frames.Series(run.folder / "post", "outline").frames[-1][1])[0][0]
        self.drag = drag.coefficient(self.history["drag"], 1.0, 1.0)
        self.lift = drag.coefficient(self.history["lift"], 1.0, 1.0)
        self.sheds = run.variables["re"] > SHEDS_ABOVE
        self.oscillation = histories.Oscillation(self.history.time, self.lift) if self.sheds else None

    def mean_drag(self):
        return self.oscillation.mean_of(self.history.time, self.drag) if self.sheds else float(self.drag[-1])

    def height(self):
        """Of the box; drag is slightly higher where that is small."""
        frame = self.last
        return (frame.y[-1] - frame.y[0]) + frame.h

    def centre(self):
        return self.outline.mean(axis=0)

    def values(self):
        """By the names of reference.csv."""
        if self.sheds:
            return {"drag": self.mean_drag(), "lift": self.oscillation.amplitude, "strouhal": 1.0 / self.oscillation.period}
        wake = drag.wake_length(self.last, self.centre(), 1.0)
        return {"drag": self.mean_drag(), **({} if wake is None else {"wake": wake})}
