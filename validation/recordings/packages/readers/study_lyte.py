"""Reads files of the package study-lyte: a pole that is pushed into snow, with sensors in its tip, an accelerometer and a barometer.

Sensors are told in counts of a converter, accelerations in g, depths in cm, 16000 rows a second; a few rows at the end are 0.01 s apart.
"""

import numpy as np
from formats.clock import since_first
from formats.rows import summed
from formats.text import csv
from models.drifts import usual_shifts_and_drifts
from models.fitting import line, scaled, terms
from models.lags import moved

PAUSE_S = 0.005
G_CM_S2 = 981


def table(content):
    """Rows of a push; above them stand lines such as `SAMPLE RATE = 16000`."""
    lines = content.decode().splitlines()
    return csv(content, skiprows=next(k for k, text in enumerate(lines) if "," in text and "=" not in text))


def push(content, every):
    """One row in so many of a push, before rows come slowly."""
    frame = table(content)
    slow = np.flatnonzero(np.diff(frame.time) > PAUSE_S)
    return frame.iloc[: slow[0] + 1 if len(slow) else None : every]


def depths(content):
    """Depth in cm by the barometer, and as the acceleration along the pole adds up twice; the pole is at rest in the first hundredth of the rows."""
    frame = table(content)
    t, along = frame.time.to_numpy(), frame["Y-Axis"].to_numpy()
    down = summed(summed(-G_CM_S2 * (along - along[: len(along) // 100].mean()), t), t)
    return {"time_s": since_first(t), "push_cm": down, "barometer_cm": frame.filtereddepth.to_numpy()}


def depth_models(c):
    """Models of a depth by the barometer over one by the accelerometer, the clock in tenths of a second."""
    y, x, t = c["barometer_cm"], c["push_cm"], c["time_s"]
    u, w = scaled(x), scaled(t)
    at, hinge = lambda p: moved(u, t, p[0] * 0.1), lambda p: np.maximum(u - p[0], 0)
    return y, {
        **usual_shifts_and_drifts(y, x, t, 0.1),
        "hinge": terms(y, lambda p: [u, hinge(p)], [-0.5]),
        "drift, and hinge": terms(y, lambda p: [u, w, hinge(p)], [-0.5]),
        "drift, and cube": line(y, u, u**2, u**3, w),
        "square that is shifted": terms(y, lambda p: [at(p), at(p) ** 2], [0.3]),
        "square that is shifted, and drift": terms(y, lambda p: [at(p), at(p) ** 2, w], [0.3]),
        "cube that is shifted": terms(y, lambda p: [at(p) ** k for k in (1, 2, 3)], [0.3]),
        "drift, its square, and square": line(y, x, u**2, w, w**2),
        "square, and slope that drifts": line(y, x, u**2, w, u * w),
    }
