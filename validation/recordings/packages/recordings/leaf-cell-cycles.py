"""Voltage of a cell of an electric car in the second to the fifth discharge at twice its rate, with rest and charge after each, over that of the first at the same time since its start. They agree."""

import numpy as np
from models.lags import usual
from readers.celljar import cycler

HAND_BUILT = "shift"


def rows(content):
    frame = cycler(content)
    begins = (frame["mode"] == "DCHG") & (frame["mode"].shift() != "DCHG")
    starts = [*frame.time_s[begins], np.inf]
    cycles = [frame[(frame.time_s >= a) & (frame.time_s < min(b, a + 11800))].assign(since=lambda d, a=a: d.time_s - a) for a, b in zip(starts, starts[1:])]
    first, later = cycles[0], cycles[1:]
    join = lambda pick: np.concatenate([np.asarray(pick(cycle)) for cycle in later])
    t = join(lambda cycle: cycle.time_s)
    return {"time_s": t - t[0], "first_v": join(lambda cycle: np.interp(cycle.since, first.since, first.volt)), "later_v": join(lambda cycle: cycle.volt)}


def models(c):
    y, x, t = c["later_v"], c["first_v"], c["time_s"]
    return y, usual(y, x, t)
