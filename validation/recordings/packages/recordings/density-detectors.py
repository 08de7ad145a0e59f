"""Density by the far detector of a probe in a cased hole over that by the near one, 10 to 135 m, each 5 cm. A row counts as a second. The hole is full of water from 54 m on, of air above."""

import numpy as np
from formats.las import well_log
from models.fitting import line
from models.lags import usual

HAND_BUILT = "another zero below the water"


def rows(content):
    frame = well_log(content)
    frame = frame[frame.DEPT.between(10, 135)]
    return {"time_s": np.arange(len(frame)), "near_g_cm3": frame.DNEAR, "far_g_cm3": frame.DFAR}


def models(c):
    y, x, t = c["far_g_cm3"], c["near_g_cm3"], c["time_s"]
    below = (t > 880).astype(float)
    return y, {
        **usual(y, x, t, 10),
        HAND_BUILT: line(y, x, below),
        "another zero and gain": line(y, x, below, below * x),
        "another zero and gain, and drift": line(y, x, below, below * x, t),
    }
