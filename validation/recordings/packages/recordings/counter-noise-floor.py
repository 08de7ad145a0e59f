"""A counter that measures the interval between a signal and itself: its noise, and nothing else."""

import numpy as np
from models.fitting import line
from readers.allantools import numbers

HAND_BUILT = "constant"


def rows(content):
    return {"time_s": np.arange(2000.0), "interval_ps": (numbers(content) * 1e12)[30000:32000]}


def models(c):
    y = c["interval_ps"]
    return y, {HAND_BUILT: line(y), "line": line(y, c["time_s"])}
