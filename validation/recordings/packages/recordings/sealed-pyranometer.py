"""Pressure inside of a sealed pyranometer over the temperature of its body, three hours of a night and a dawn, a row a minute. The gas is warm or cold before the body's thermometer is."""

import numpy as np
from models.fitting import terms
from models.lags import lag, usual
from readers.nrgpy import mast_logger

HAND_BUILT = "shift, and drift"


def rows(*contents):
    frame = mast_logger(*contents)
    return {"time_s": frame.time_s, "body_c": frame.Ch109_Avg_deg_C, "inside_hpa": frame.Ch114_Avg_mbar}


def models(c):
    y, x, t = c["inside_hpa"], c["body_c"], c["time_s"]
    at = lambda p: np.interp(t - p * 60, t, x)
    late = lambda p: lag(x, t, abs(p) * 60)
    return y, {
        **usual(y, x, t),
        "shift, begun ahead": terms(y, lambda p: [at(p[0])], [-1.0]),
        "line less its lag": terms(y, lambda p: [x, late(p[0])], [3.0]),
        HAND_BUILT: terms(y, lambda p: [at(p[0]), t], [-1.0]),
        "shift, and square": terms(y, lambda p: [at(p[0]), at(p[0]) ** 2], [-1.0]),
    }
