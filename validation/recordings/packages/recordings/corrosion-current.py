"""Current of a corroding metal over its potential, one slow sweep of three hours, every second row. Each of its two reactions goes by an exponential; one comes to its limit."""

import numpy as np
from formats.text import csv
from models.fitting import line, terms
from models.lags import usual

HAND_BUILT = "two slopes"


def rows(content):
    frame = csv(content, sep=";", skiprows=1, header=None).iloc[::2]
    return {"time_s": frame[1] - frame[1].iloc[0], "potential_v": frame[0], "current_ma": frame[2] * 1000}


def models(c):
    y, x, t = c["current_ma"], c["potential_v"], c["time_s"]
    steep = lambda p: np.exp(np.minimum(x / (abs(p) * 0.1 + 1e-3), 50))
    return y, {
        **usual(y, x, t, 600),
        "cubic": line(y, x, x**2, x**3),
        "exponential": terms(y, lambda p: [x, steep(p[0])], [1.0]),
        "step of a width": terms(y, lambda p: [1 / (1 + np.exp(-(x - p[0]) / (abs(p[1]) * 0.1 + 1e-3)))], [0.3, 0.5]),
        HAND_BUILT: terms(y, lambda p: [x, np.maximum(x - p[0], 0)], [0.2]),
    }
