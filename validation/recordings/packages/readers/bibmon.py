"""Reads files of the package bibmon, and holds models that its recordings share."""

import numpy as np
import pandas as pd
from durations import DAY
from formats.clock import seconds
from formats.text import csv
from models.cycles import tone
from models.fitting import line, scaled, terms
from models.jumps import changed
from models.lags import lag, usual_and_shifts


def plant_tags(content, **names):
    """Columns of a plant by the names that they are to have; seconds since the first row."""
    frame = csv(content)
    columns = {name: pd.to_numeric(frame[column], errors="coerce") for name, column in names.items()}
    return {"time_s": seconds(pd.to_datetime(frame.iloc[:, 0])), **columns}


def days_and_changes(y, x, t):
    """Models of what goes with the time of day beside a bend, a drift and a zero or a slope that changes at some time."""
    u, w, day, one = scaled(x), scaled(t), [*tone(t, DAY), *tone(t, DAY / 2)], np.ones(len(y))
    return {
        "one wave a day": line(y, x, *tone(t, DAY)),
        "day": line(y, x, *day),
        "three waves a day": line(y, x, *day, *tone(t, DAY / 3)),
        "step": changed(y, t, [x], one),
        "day, and square": line(y, x, u**2, *day),
        "day, and cube": line(y, x, u**2, u**3, *day),
        "day, and drift": line(y, x, w, *day),
        "day, drift, and its square": line(y, x, w, w**2, *day),
        "day, and slope that drifts": line(y, x, w, u * w, *day),
        "day, and slope by it": line(y, x, *day, *(u * part for part in day)),
        "day, and step": changed(y, t, [x, *day], one),
        "day, and slope that changes": changed(y, t, [x, *day], u),
        "day alone": line(y, *day),
    }


def instrument_models(c):
    """Two instruments of a plant, and models of one over the other."""
    y, x, t = c["second"], c["first"], c["time_s"]
    u, w = scaled(x), scaled(t)
    return y, {
        **usual_and_shifts(y, x, t, 300),
        "cube": line(y, x, u**2, u**3),
        "drift, and its square": line(y, x, w, w**2),
        "line, and lag": terms(y, lambda p: [x, lag(x, t, abs(p[0]) * 1800)], [2.0]),
        **days_and_changes(y, x, t),
    }
