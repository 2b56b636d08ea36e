"""The numbers of a run of the channel with a cylinder, by the names of reference.csv."""

import drag
import fields
import histories

DIAMETER, CENTRE_X = 0.1, 0.2


def values(run):
    history, last = histories.History(run), fields.last(run)
    mean = 2.0 * run.variables["peak"] / 3.0
    centre = CENTRE_X, run.variables["centre_y"]
    wake = drag.wake_length(last, centre, DIAMETER)
    front, back = (drag.surface_pressure(last, centre, DIAMETER, side) for side in (-1, 1))
    return {"drag": drag.coefficient(history.last("drag"), mean, DIAMETER), "lift": drag.coefficient(history.last("lift"), mean, DIAMETER),
            "pressure_drop": float(front - back), **({} if wake is None else {"wake": float(wake)})}
