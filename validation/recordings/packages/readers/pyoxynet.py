"""Reads files of the package pyoxynet, and holds models that its recordings share."""

import numpy as np
from formats.text import csv
from models.fitting import line, scaled, terms
from models.lags import lag, moved, usual_and_shifts


def exercise(content, every, **names):
    """Columns of an exercise test by the names that they are to have, each so many seconds: between breaths the table is straight."""
    frame = csv(content).iloc[::every]
    return {"time_s": frame.time - frame.time.iloc[0], **{name: frame[column] for name, column in names.items()}}


def heart_models(c):
    """Heart beats over oxygen, and their models: what comes late, what bends, and what drifts."""
    y, x, t = c["heart_per_min"], c["oxygen_ml_min"], c["time_s"]
    u, w, late = scaled(x), scaled(t), lambda p: lag(x, t, abs(p) * 20)
    bend = lambda p: (late(p[0]), scaled(late(p[0])) ** 2, scaled(late(p[0])) ** 3)
    return y, {
        **usual_and_shifts(y, x, t, 20),
        "cube": line(y, x, u**2, u**3),
        "drift, and its square": line(y, x, w, w**2),
        "drift, and slope that drifts": line(y, x, w, u * w),
        "square, and drift": line(y, x, u**2, w),
        "cube, and drift": line(y, x, u**2, u**3, w),
        "logarithm": line(y, x, np.log(t + 10)),
        "lag, and square": terms(y, lambda p: bend(p)[:2], [1.0]),
        "lag, and cube": terms(y, bend, [1.0]),
        "lag, and drift": terms(y, lambda p: [late(p[0]), w], [1.0]),
        "lag, cube, and drift": terms(y, lambda p: [*bend(p), w], [1.0]),
        "line, and lag": terms(y, lambda p: [x, late(p[0])], [1.0]),
        "two lags": terms(y, lambda p: [late(p[0]), late(p[1])], [1.0, 4.0]),
        "lag of a lag": terms(y, lambda p: [lag(late(p[0]), t, abs(p[1]) * 20)], [1.0, 0.5]),
        "lag, and shift": terms(y, lambda p: [moved(late(p[0]), t, p[1] * 20)], [1.0, 0.5]),
        "drift alone": line(y, w),
    }
