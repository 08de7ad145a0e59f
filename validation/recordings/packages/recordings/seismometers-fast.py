"""A seismometer beside a better one on the same floor, 20 s at 200 readings a second. What shakes fast comes earlier in it, by some ten milliseconds."""

import numpy as np
from models.fitting import line, terms
from models.lags import lag
from readers.obspy import seismogram

HAND_BUILT = "rate"


def rows(better, other):
    better, other = (seismogram(content, 4000) for content in (better, other))
    return {"time_s": np.arange(len(better)) * 0.005, "better_counts": better, "other_counts": other}


def models(c):
    y, x, t = c["other_counts"], c["better_counts"], c["time_s"]
    return y, {
        "line": line(y, x),
        "square": line(y, x, x**2),
        "drift": line(y, x, t),
        "shift": terms(y, lambda p: [np.interp(t - p[0] * 0.005, t, x)], [-1.0]),
        "lag": terms(y, lambda p: [lag(x, t, abs(p[0]) * 0.005)], [-1.0]),
        "line and lag": terms(y, lambda p: [x, lag(x, t, abs(p[0]) * 0.005)], [1.0]),
        HAND_BUILT: line(y, x, np.gradient(x, t)),
    }
