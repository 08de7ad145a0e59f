"""Ground at 1 m over ground at 0.1 m where it stays frozen below, 2.6 years, every sixth hour. Heat is late, and where water freezes the ground stays near 0 degC."""

import numpy as np
from formats.clock import seconds
from formats.text import csv
from models.cycles import tone
from models.fitting import line, terms
from models.lags import lag, usual

HAND_BUILT = "lag with a corner"
DAY = 86400.0


def rows(content):
    frame = csv(content).dropna().iloc[::6]
    return {"time_s": seconds(frame["date_YYYY-MM-DD"] + " " + frame["time_HH:MM:SS"]), "shallow_c": frame["0.1_m"], "deep_c": frame["1_m"]}


def models(c):
    y, x, t = c["deep_c"], c["shallow_c"], c["time_s"]
    late = lambda p: lag(x, t, abs(p) * DAY)
    return y, {
        **usual(y, x, t, DAY),
        "line and lag": terms(y, lambda p: [x, late(p[0])], [10.0]),
        "bent lag": terms(y, lambda p: [late(p[0]), late(p[0]) ** 2], [10.0]),
        HAND_BUILT: terms(y, lambda p: [late(p[0]), np.minimum(late(p[0]), 0)], [10.0]),
        "year": line(y, x, *tone(t, 365.25 * DAY)),
    }
