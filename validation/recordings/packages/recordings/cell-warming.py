"""Temperature on a lithium cell that is charged and discharged, every second row of two cycles, beside the size of the current, of either sign. Its heat arrives late, and the zero drifts."""

import numpy as np
from formats.text import csv
from models.fitting import line, terms
from models.lags import lag

HAND_BUILT = "late current and drift"


def rows(content):
    frame = csv(content).iloc[::2]
    return {"time_s": frame.Test_Time, "current_a": np.abs(frame.Current), "skin_c": frame.Temperature}


def models(c):
    y, i, t = c["skin_c"], c["current_a"], c["time_s"]
    return y, {
        "constant": line(y),
        "drift": line(y, t),
        "current": line(y, i),
        "current, bent": line(y, i, i**2),
        "late current": terms(y, lambda p: [lag(i, t, abs(p[0]) * 600)], [1.0]),
        "late square of current": terms(y, lambda p: [lag(i**2, t, abs(p[0]) * 600)], [1.0]),
        HAND_BUILT: terms(y, lambda p: [lag(i, t, abs(p[0]) * 600), t], [1.0]),
    }
