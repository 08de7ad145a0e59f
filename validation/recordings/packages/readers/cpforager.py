"""Reads files of the package cpforager, and holds models that its recordings share."""

import pandas as pd
from formats.clock import seconds
from formats.text import csv
from models.fitting import line, terms
from models.lags import lag


def bird_logger(content):
    """Depth and temperature of a logger on a bird, with seconds since its first row."""
    frame = csv(content).dropna()
    when = pd.to_datetime(frame.date + " " + frame.time, format="mixed")
    frame = frame.assign(time_s=seconds(when))
    return frame[frame.time_s.diff().fillna(1) > 0]


def out_of_water(content, rows=3000):
    """So many rows at which the bird is calm, not under water: 61 rows scatter by less than 0.08 m, and this one is less than 1 m deep."""
    frame = bird_logger(content)
    frame = frame[(frame.pressure.rolling(61, center=True).std() < 0.08) & (frame.pressure < 1)]
    frame = frame.iloc[:: max(1, len(frame) // rows)]
    return frame.assign(time_s=frame.time_s - frame.time_s.iloc[0])


def zero_models(y, x, t):
    """Models of a zero `y` by the temperature `x` of its logger and the time `t`."""
    late = lambda p: lag(x, t, abs(p) * 600)
    return {
        "constant": line(y),
        "drift": line(y, t),
        "temperature": line(y, x),
        "temperature, bent": line(y, x, x**2),
        "temperature, and drift": line(y, x, t),
        "temperature, bent, and drift": line(y, x, x**2, t),
        "temperature, and late temperature": terms(y, lambda p: [x, late(p[0])], [1.0]),
        "temperature, late temperature, and drift": terms(y, lambda p: [x, late(p[0]), t], [1.0]),
    }
