"""Relative humidity inside of a counter of fine particles over its temperature while it warms up, 72 min, every fourth row. Warm air holds more water, and not straight."""

import numpy as np
from models.fitting import line
from models.lags import usual
from readers.aerosoltools import partector

HAND_BUILT = "square"


def rows(content):
    frame = partector(content)
    return {"time_s": frame.time - frame.time.iloc[0], "inside_c": frame["T"], "humidity_pct": frame.RH}


def models(c):
    y, x, t = c["humidity_pct"], c["inside_c"], c["time_s"]
    return y, {**usual(y, x, t), "vapour": line(y, np.exp(-17.6 * x / (243 + x))), "square, and drift": line(y, x, x**2, t)}
