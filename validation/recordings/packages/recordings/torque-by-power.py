"""Torque of the shaft of a wind turbine by strain gauges over the power that it feeds in, ten minutes. The gauges tell of the bending of the shaft as well, once a turn."""

from models.fitting import line, terms
from models.lags import lag, moved, usual
from readers.wetb import turbine_sensors

HAND_BUILT = "bending, shifted, and square"


def rows(content):
    read = turbine_sensors(content)
    return {"time_s": read["time_s"], "power_kw": read["Power"], "bending_v": read["MX_90"], "torque_knm": read["MY"]}


def models(c):
    y, x, t, b = c["torque_knm"], c["power_kw"], c["time_s"], c["bending_v"]
    later = lambda p: moved(b, t, p)
    return y, {
        **usual(y, x, t, 2),
        "bending": line(y, x, b),
        "bending, and square": line(y, x, x**2, b),
        "bending, and drift": line(y, x, b, t),
        "bending with power": line(y, x, b, x * b),
        "bending, shifted": terms(y, lambda p: [x, later(p[0])], [-0.3]),
        "bending, shifted, and square": terms(y, lambda p: [x, x**2, later(p[0])], [-0.3]),
        "bending, late": terms(y, lambda p: [x, lag(b, t, abs(p[0]))], [0.5]),
        "bending, now and late": terms(y, lambda p: [x, b, lag(b, t, abs(p[0]))], [0.5]),
    }
