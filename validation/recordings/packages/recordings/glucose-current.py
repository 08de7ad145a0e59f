"""Glucose that a sensor under the skin tells, over the current of its electrode, 5 min, six days of one sensor. Its wearer calibrated it; to the end it gave less current for the same glucose."""

import numpy as np
import pandas as pd
from formats.clock import seconds
from formats.text import csv
from models.fitting import line, terms

HAND_BUILT = "gain by time, bent"


def rows(content):
    frame = csv(content, compression="gzip", parse_dates=["datetime"])
    frame = frame[(frame.datetime >= "2010-06-25 00:58") & (frame.datetime < "2010-07-01 12:00")]
    frame = frame.assign(isig=pd.to_numeric(frame.isig, errors="coerce"), glucose=pd.to_numeric(frame.glucose, errors="coerce")).dropna()
    return {"time_s": seconds(frame.datetime), "current_na": frame.isig, "glucose_mg_dl": frame.glucose}


def models(c):
    y, x, t = c["glucose_mg_dl"], c["current_na"], c["time_s"]
    after = lambda p: np.clip((t / t[-1] - p[0]) / (abs(p[1]) + 0.01), 0, 1)
    return y, {
        "line": line(y, x),
        "square": line(y, x, x**2),
        "drift": line(y, x, t),
        "shift": terms(y, lambda p: [np.interp(t - p[0] * 600, t, x)], [0.5]),
        "gain by time": line(y, x, x * t),
        HAND_BUILT: line(y, x, x * t, x * t**2),
        "gain that changes over a time": terms(y, lambda p: [x, x * after(p)], [0.6, 0.4]),
        "gain and zero that change": terms(y, lambda p: [x, x * after(p), after(p)], [0.6, 0.4]),
    }
