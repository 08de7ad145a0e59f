"""Current of an electrode that makes oxygen over its potential, up and down once in 70 s. It goes by an exponential that the resistance of the cell makes straight, and fades with time."""

import numpy as np
from models.fitting import line, terms
from models.lags import lag, usual
from readers.ec4py import tdms

HAND_BUILT = "soft bend that fades"


def rows(content):
    found = tdms(content)
    return {"time_s": found["Time"], "potential_v": found["E"], "current_ma": found["i_2"] * 1000}


def models(c):
    y, x, t = c["current_ma"], c["potential_v"], c["time_s"]
    against = np.sign(35 - t)
    steep = lambda p: np.exp((x - 1) / (abs(p) * 0.1))
    soft = lambda p: np.logaddexp(0, (x - p[0]) / (abs(p[1]) * 0.1))
    return y, {
        **usual(y, x, t, 1),
        "cubic": line(y, x, x**2, x**3),
        "exponential": terms(y, lambda p: [x, steep(p[0])], [0.5]),
        "exponential, and direction": terms(y, lambda p: [x, steep(p[0]), against], [0.5]),
        "soft bend": terms(y, lambda p: [soft(p)], [0.8, 0.5]),
        "soft bend, and direction": terms(y, lambda p: [x, soft(p), against], [0.8, 0.5]),
        "soft bend by a gain that drifts": terms(y, lambda p: [soft(p), t * soft(p)], [0.8, 0.5]),
        HAND_BUILT: terms(y, lambda p: [soft(p), lag(soft(p), t, abs(p[2]) * 10)], [0.8, 0.5, 0.5]),
    }
