"""Soot by the laser through the filter of a carbon analyser over that by an instrument that makes up for what its filter holds, two months of a town. A full filter sees less, and the first days are off."""

from models.fitting import line, terms
from models.jumps import soft_step
from models.lags import usual_and_lags
from readers.aeroviz import air_station

HAND_BUILT = "square, drift, and its square"


def rows(content):
    read = air_station(content, "BC", "O_EC")
    return {"time_s": read.time_s, "spot_ug_m3": read.BC / 1000, "filter_ug_m3": read.O_EC}


def models(c):
    y, x, t = c["filter_ug_m3"], c["spot_ug_m3"] / 2, c["time_s"] / 86400
    after = lambda p: soft_step(t, p * 10, 0.2)
    return y, {
        **usual_and_lags(y, x, c["time_s"], 3600),
        "cube": line(y, x, x**2, x**3),
        "square, and drift": line(y, x, x**2, t),
        "square, drift, and its square": line(y, x, x**2, t, t**2),
        "drift, and its square": line(y, x, t, t**2),
        "step": terms(y, lambda p: [x, after(p[0])], [0.25]),
        "square, and step": terms(y, lambda p: [x, x**2, after(p[0])], [0.25]),
        "square, step, and drift": terms(y, lambda p: [x, x**2, after(p[0]), t], [0.25]),
    }
