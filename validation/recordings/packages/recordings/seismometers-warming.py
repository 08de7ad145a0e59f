"""A seismometer beside a better one on the same floor, ten minutes, means of 0.2 s. It was switched on not long before, and its zero still wanders."""

import numpy as np
from formats.rows import means
from models.fitting import line, terms
from models.lags import lag
from readers.obspy import seismogram

HAND_BUILT = "drift"


def rows(better, other):
    better, other = (means(seismogram(content, 120000), 40) for content in (better, other))
    return {"time_s": np.arange(len(better)) * 0.2, "better_counts": better, "other_counts": other}


def models(c):
    y, x, t = c["other_counts"], c["better_counts"], c["time_s"]
    return y, {
        "line": line(y, x),
        "square": line(y, x, x**2),
        HAND_BUILT: line(y, x, t),
        "shift": terms(y, lambda p: [np.interp(t - p[0] * 0.2, t, x)], [0.5]),
        "lag": terms(y, lambda p: [lag(x, t, abs(p[0]) * 0.2)], [0.5]),
        "drift, bent": line(y, x, t, t**2),
        "drift that fades": terms(y, lambda p: [x, np.exp(-t / (abs(p[0]) * 600))], [1.0]),
    }
