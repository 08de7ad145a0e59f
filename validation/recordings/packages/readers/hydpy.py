"""Reads files of the package hydpy."""

import numpy as np
from durations import DAY


def daily_numbers(content):
    """Numbers of days behind a head of three lines that ends with `"1d")`."""
    return np.array(content.decode().split('"1d")')[1].split(), float)


def valley(*contents, first, days, names):
    """Columns of days, so many from one on; seconds since the first."""
    return {"time_s": np.arange(days) * DAY, **{name: daily_numbers(content)[first : first + days] for name, content in zip(names, contents)}}
