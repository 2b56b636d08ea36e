"""The drag of a run of the Stokes channel, and what it is compared with."""

import math

import histories

FAXEN_UP_TO = 0.25  # k
FAXEN = (1.7243844, -1.7301940, 2.4056440, -4.5913120)
AVERAGED = 0.9      # of the time has passed when the mean over the rest is taken: a moving disc crosses many cells in it


def drag(run):
    """F / (mu U), positive against the motion of the disc relative to the walls."""
    history = histories.History(run)
    sign = -1.0 if run.variables["setting"] == "moving" else 1.0
    return float(sign * history["drag"][history.since(AVERAGED * history.time[-1])].mean())


def faxen(k):
    """F / (mu U) by Faxen (1946)."""
    return 4.0 * math.pi / (-0.9156892732 - math.log(k) + sum(c * k ** (2 * n) for n, c in enumerate(FAXEN, start=1)))


def published(run):
    """Exact where it is tabulated, Faxen's series where that holds, else None."""
    k = run.variables["k"]
    if run.variables["off_wall"]:
        return None
    exact = next((row["exact"] for row in run.reference if row["k"] == k), None)
    return exact if exact is not None else faxen(k) if k <= FAXEN_UP_TO else None
