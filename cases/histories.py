"""The numbers over time that a case writes to history.csv: columns as arrays, steadiness, oscillations."""

import numpy as np

import caselib


class History:
    """history["drag"] is a column; all have as many entries as history.time."""

    def __init__(self, run):
        rows = caselib.read_csv(run.folder / "history.csv")
        self.columns = {name: np.array([row[name] for row in rows]) for name in rows[0]}
        self.time = self.columns["time"]

    def __getitem__(self, name):
        return self.columns[name]

    def last(self, name):
        return float(self.columns[name][-1])

    def since(self, time):
        return self.time >= time

    def finite(self):
        return all(np.isfinite(values).all() for values in self.columns.values())

    def drift(self, name):
        """Largest distance of the last tenth from its end, relative to that end: 0 when steady."""
        values = self[name][self.since(0.9 * self.time[-1])]
        return float(np.abs(values - values[-1]).max() / abs(values[-1]))


def check_flow(table, history, last, velocity, length):
    """What must hold for any values: finite, and free of divergence in units of velocity / length."""
    table.at_most("values that are not finite", 0 if history.finite() and last.finite() else 1, 0)
    table.at_most("divergence of face velocities, largest reading, times length / velocity", float(history["divergence"].max()) * length / velocity, 1e-9)


class Oscillation:
    """The whole periods at the end of a signal, at most `most`: their number, mean period, mean value, amplitude, and how
    much period and amplitude still change. Periods are counted between upward crossings of the mean."""

    def __init__(self, time, values, most=10):
        centred = values - values[len(values) // 2:].mean()
        ups = np.flatnonzero((centred[:-1] < 0) & (centred[1:] >= 0))
        times = time[ups] - centred[ups] * (time[ups + 1] - time[ups]) / (centred[ups + 1] - centred[ups])
        self.begin, self.end = (times[max(0, len(times) - 1 - most)], times[-1]) if len(times) > 1 else (np.nan, np.nan)
        self.periods = min(most, max(0, len(times) - 1))
        lengths = np.diff(times)[-self.periods:] if self.periods else np.array([np.nan])
        self.period, self.period_spread = lengths.mean(), np.ptp(lengths) / lengths.mean()
        peaks = [np.ptp(values[a + 1:b + 1]) / 2 for a, b in zip(ups[-self.periods - 1:-1], ups[-self.periods:])] or [np.nan]
        self.amplitude, self.amplitude_spread = np.mean(peaks), np.ptp(peaks) / np.mean(peaks)

    def mean_of(self, time, values):
        """Mean of any signal over these periods."""
        inside = (time >= self.begin) & (time <= self.end)
        return np.trapz(values[inside], time[inside]) / np.ptp(time[inside]) if inside.sum() > 1 else np.nan
