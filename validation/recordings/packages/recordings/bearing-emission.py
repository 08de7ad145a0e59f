"""Acoustic emission of a bearing as it speeds up, runs and runs down, over the voltage of an analogue input: a curve.

The package does not say what the input is; it rises, stays and falls with the emission.
"""

import sqlite3

import numpy as np
from models.fitting import line, terms
from models.lags import lag

HAND_BUILT = "power"


def rows(content):
    base = sqlite3.connect(":memory:")
    base.deserialize(content)
    parameters = np.array(base.execute("select Time, PA0 from ae_data where SetType = 1 and PA0 is not null order by SetID").fetchall(), float)
    hits = np.array(base.execute("select Time, RMS from ae_data where SetType = 2 order by SetID").fetchall(), float)
    (to_mv,) = base.execute("select PA0_mV from ae_params where ID = 1").fetchone()
    (to_uv,) = base.execute("select ADC_µV from ae_params where ID = 2").fetchone()
    at = np.isin(hits[:, 0], parameters[:, 0])
    of = dict(parameters)
    volts = np.array([of[time] for time in hits[at, 0]])
    return {"time_s": hits[at, 0] * 1e-7, "input_mv": volts * to_mv, "emission_uv": hits[at, 1] * to_uv * 6.5536e-3}


def models(c):
    y, x, t = c["emission_uv"], c["input_mv"], c["time_s"]
    power = terms(y, lambda p: [np.maximum(x, 1) ** p[0]], [2.0])
    late = terms(y, lambda p: [np.maximum(lag(x, t, abs(p[1])), 1) ** p[0]], [2.0, 0.05])
    return y, {"line": line(y, x), HAND_BUILT: power, "power, with a lag": late, "cubic": line(y, x, x**2, x**3), "and time": line(y, x, x**2, x**3, t, x * t)}
