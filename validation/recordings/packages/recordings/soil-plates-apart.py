"""Heat that flows into the soil through one plate of a station over that through its other plate, eight days of spring, a row each half hour. At one of them the heat comes later."""

import numpy as np
from models.fitting import terms
from models.lags import lag, usual
from readers.micromet import tob1

HAND_BUILT = "line less its lag, and square"


def rows(content):
    frame = tob1(content)
    return {"time_s": frame.time_s, "second_w_m2": frame.G_plate_2_1_1, "first_w_m2": frame.G_plate_1_1_1}


def models(c):
    y, x, t = c["first_w_m2"], c["second_w_m2"], c["time_s"]
    at = lambda p: np.interp(t - p * 3600, t, x)
    return y, {
        **usual(y, x, t, 3600),
        "shift, begun ahead": terms(y, lambda p: [at(p[0])], [-1.0]),
        "shift, and square": terms(y, lambda p: [at(p[0]), at(p[0]) ** 2], [-1.0]),
        "shift, and drift": terms(y, lambda p: [at(p[0]), t], [-1.0]),
        "line less its lag": terms(y, lambda p: [x, lag(x, t, abs(p[0]) * 3600)], [3.0]),
        HAND_BUILT: terms(y, lambda p: [x, x**2, lag(x, t, abs(p[0]) * 3600)], [3.0]),
    }
