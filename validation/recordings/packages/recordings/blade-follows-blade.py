"""Bending of one blade of a wind turbine at its root over that of another, ten minutes. It comes where the other was a third of a turn later."""

from models.fitting import terms
from models.lags import lag, moved, usual
from readers.wetb import turbine_sensors

HAND_BUILT = "two shifts"


def rows(content):
    read = turbine_sensors(content)
    return {"time_s": read["time_s"], "first_knm": read["MBX_A"], "second_knm": read["MBX_B"]}


def models(c):
    y, x, t = c["second_knm"], c["first_knm"], c["time_s"]
    later = lambda p: moved(x, t, 2 * p)
    return y, {
        **usual(y, x, t, 3.6),
        "shift, and drift": terms(y, lambda p: [later(p[0]), t], [0.9]),
        "shift, and square": terms(y, lambda p: [later(p[0]), later(p[0]) ** 2], [0.9]),
        "shift, and lag": terms(y, lambda p: [lag(later(p[0]), t, abs(p[1]))], [0.9, 0.1]),
        "shift, and what is now": terms(y, lambda p: [later(p[0]), x], [0.9]),
        "two shifts": terms(y, lambda p: [later(p[0]), later(p[1])], [0.9, 3.8]),
    }
