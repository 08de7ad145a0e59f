"""Times of rows, as seconds since the first."""

import re

import numpy as np
import pandas as pd


def seconds(times):
    """Seconds since the first of some times, which may be told as text."""
    times = pd.DatetimeIndex(times)
    return (times - times[0]).total_seconds().to_numpy()


def since_first(values):
    """Values less the first."""
    values = np.asarray(values, float)
    return values - values[0]


TIME_OF_DAY = re.compile(r"\d+:\d\d:\d\d")


def elapsed(times):
    """Seconds since the first of some, to 0.1 ms."""
    return since_first(times).round(4)
