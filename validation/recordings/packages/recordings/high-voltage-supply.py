"""High voltage of a detector in a soot photometer on a ship in the ice, a day in means of a minute, as its chamber cools and warms by 10 K: 27 mV/K."""

import io

import numpy as np
import pandas as pd
from formats.rows import means
from models.fitting import line, terms
from models.lags import lag

HAND_BUILT = "temperature, and its lag"


def rows(content):
    names = {"chamber_c": "Chamber Temp (C)", "chamber_hpa": "Chamber Pressure (mBar)", "high_voltage": "Chan 3 HV (V)"}
    d = pd.read_csv(io.BytesIO(content), sep="\t", usecols=["Time (sec)", *names.values()])
    t = means(d["Time (sec)"], 60)
    return {"time_s": (t - t[0]).round(1), **{name: means(d[column], 60) for name, column in names.items()}}


def models(c):
    y, x, t = c["high_voltage"], c["chamber_c"], c["time_s"]
    return y, {
        "constant": line(y),
        "temperature": line(y, x),
        "square of temperature": line(y, x, x**2),
        "lagged temperature": terms(y, lambda p: [lag(x, t, abs(p[0]) * 60)], [10.0]),
        HAND_BUILT: terms(y, lambda p: [x, lag(x, t, abs(p[0]) * 60)], [30.0]),
        "temperature and drift": line(y, x, t),
        "temperature and pressure": line(y, x, c["chamber_hpa"]),
    }
