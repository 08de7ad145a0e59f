"""Transducers of the two plates of a heat flow meter, the upper one with its sign turned, at seven temperatures; a row is a block of readings. The lower one follows the temperature of the plates."""

import numpy as np
from models.fitting import line, terms
from models.lags import lag
from readers.pyhfm import heat_flow_meter

HAND_BUILT = "temperature"


def rows(content):
    frame = heat_flow_meter(content)
    return {"time_s": np.arange(len(frame)), "upper_uv": -frame.upper_uv, "lower_uv": frame.lower_uv, "plates_c": (frame.upper_c + frame.lower_c) / 2}


def models(c):
    y, x, t, plates = c["lower_uv"], c["upper_uv"], c["time_s"], c["plates_c"]
    return y, {
        "line": line(y, x),
        "square": line(y, x, x**2),
        "drift": line(y, x, t),
        "line and lag": terms(y, lambda p: [x, lag(x, t, abs(p[0]) * 3)], [1.0]),
        HAND_BUILT: line(y, x, plates),
        "temperature, bent": line(y, x, plates, plates**2),
        "temperature and drift": line(y, x, plates, t),
        "gain by temperature": line(y, x, (plates - 20) * x),
    }
