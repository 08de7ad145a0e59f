"""Reads files of the package hisparc-sapphire, and holds models that its recordings share."""

import numpy as np
from durations import GREGORIAN_YEAR
from formats.clock import since_first
from formats.text import matrix
from models.cycles import tone
from models.fitting import line


def detector(content, begin=0):
    """Rows of the days on which the time of the first detector of a station against the second was found, from one of them on: seconds since then, and that time in ns."""
    table = matrix(content)
    table = table[np.isfinite(table[:, 1])][begin:]
    return {"time_s": since_first(table[:, 0]), "late_ns": table[:, 1]}


def detector_models(c):
    """Its reading, and what is tried for it."""
    return c["late_ns"], drift_models(c["late_ns"], c["time_s"])


def drift_models(y, t):
    """What is tried where nothing is recorded but a clock: a drift, its square, a year, and a step where it takes most."""
    halves = [np.var(y[:k]) * k + np.var(y[k:]) * (len(y) - k) for k in range(10, len(y) - 10)]
    step = (np.arange(len(y)) >= 10 + int(np.argmin(halves))).astype(float)
    year = tone(t, GREGORIAN_YEAR)
    return {
        "constant": line(y),
        "drift": line(y, t),
        "drift, and its square": line(y, t, t**2),
        "year": line(y, *year),
        "year, and half a year": line(y, *year, *tone(t, GREGORIAN_YEAR / 2)),
        "year, and drift": line(y, *year, t),
        "step": line(y, step),
        "step, and drift": line(y, step, t),
        "step, and a drift before and after": line(y, step, t, step * t),
        "step, and year": line(y, step, *year),
    }
