"""Heat flow of setting cement in one channel of a calorimeter over that of another, two days, each 40 s, from 100 min on. The second cement is the later one by a quarter of an hour."""

import numpy as np
from models.fitting import terms
from models.lags import lag, usual
from readers.calocem import cement_calorimeter

HAND_BUILT = "shift"


def rows(content):
    frame = cement_calorimeter(content, 6000)
    return {"time_s": frame.time_s, "first_mw": frame["Kanal 3"], "second_mw": frame["Kanal 5"]}


def models(c):
    y, x, t = c["second_mw"], c["first_mw"], c["time_s"]
    shifted = lambda p: np.interp(t - p * 600, t, x)
    return y, {
        **usual(y, x, t, 600),
        "shift, and square": terms(y, lambda p: [shifted(p[0]), shifted(p[0]) ** 2], [1.0]),
        "shift, and lag": terms(y, lambda p: [lag(shifted(p[0]), t, abs(p[1]) * 600)], [1.0, 0.5]),
        "shift, and drift": terms(y, lambda p: [shifted(p[0]), t], [1.0]),
    }
