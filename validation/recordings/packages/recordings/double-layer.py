"""Current of an electrode over its potential, up and down once in 1.2 s, where nothing reacts. It charges a capacitor: the current has the sign of the sweep, and comes to rest after each turn."""

import numpy as np
from models.fitting import line, terms
from models.lags import lag, usual
from readers.ec4py import tdms

HAND_BUILT = "late direction"


def rows(content):
    found = tdms(content)
    return {"time_s": found["Time"], "potential_v": found["E"], "current_ma": found["i_2"] * 1000}


def models(c):
    y, x, t = c["current_ma"], c["potential_v"], c["time_s"]
    speed = np.gradient(x, t)
    against = np.tanh(speed / 0.05)
    return y, {
        **usual(y, x, t, 0.1),
        "direction": line(y, x, against),
        "direction, and square": line(y, x, x**2, against),
        "line and lag": terms(y, lambda p: [x, lag(x, t, abs(p[0]) * 0.1)], [0.5]),
        HAND_BUILT: terms(y, lambda p: [x, lag(against, t, abs(p[0]) * 0.1)], [0.5]),
        "late direction, and square": terms(y, lambda p: [x, x**2, lag(against, t, abs(p[0]) * 0.1)], [0.5]),
    }
