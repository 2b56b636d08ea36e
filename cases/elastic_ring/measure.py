"""Semi-axes and area of the ring over time."""

import math

import ellipses
import exact

START = 0.75, 0.5


class Shapes:
    """Times in mu / kappa, semi-axes and area, all of them as the smooth curve through the points has them."""

    def __init__(self, run):
        variables = run.variables
        frames = ellipses.of_run(run)
        points = math.ceil(2 * math.pi * variables["across"] * variables["per_cell"])
        smooth = ellipses.inscribed(points)
        self.time = [time * variables["kappa"] / variables["mu"] for time, _ in frames]
        self.axes = [(shape.long / math.sqrt(smooth), shape.short / math.sqrt(smooth)) for _, shape in frames]
        self.area_errors = [shape.area / smooth / (math.pi * START[0] * START[1]) - 1 for _, shape in frames]
        self.expected = [exact.semi_axes(*START, time) for time in self.time]

    def axis_errors(self):
        """Relative, of both semi-axes at all times, by time."""
        return [tuple(value / exact_value - 1 for value, exact_value in zip(pair, both)) for pair, both in zip(self.axes, self.expected)]

    def largest_axis_error(self):
        return max(abs(error) for pair in self.axis_errors() for error in pair)

    def largest_area_error(self):
        return max(map(abs, self.area_errors))
