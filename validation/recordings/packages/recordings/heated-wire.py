"""Answer of a heated wire to a random input, a benchmark of system identification: means of 100 samples, the first 1500. The wire keeps its heat."""

import numpy as np
from formats.arrays import array
from formats.rows import means
from models.fitting import line, terms
from models.lags import lag

HAND_BUILT = "lag"


def rows(content):
    t, power, out = (means(column, 100)[:1500] for column in array(content).T)
    return {"time_s": t, "power_in": power, "out_v": out}


def models(c):
    y, x, t = c["out_v"], c["power_in"], c["time_s"]
    return y, {
        "line": line(y, x),
        "square": line(y, x, x**2),
        "shift": terms(y, lambda p: [np.interp(t - p[0] * 0.005, t, x)], [0.1]),
        HAND_BUILT: terms(y, lambda p: [lag(x, t, abs(p[0]) * 0.005)], [1.0]),
        "two lags": terms(y, lambda p: [lag(x, t, abs(q) * 0.005) for q in p], [0.5, 3.0]),
    }
