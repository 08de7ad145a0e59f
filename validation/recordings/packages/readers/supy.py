"""Reads files of the package supy."""

import numpy as np
from durations import HOUR
from formats.text import csv


def town(content, first, hours, **names):
    """Columns of a year of hours by the names that they are to have, so many hours from one on; seconds since the first."""
    frame = csv(content, sep=r"\s+").iloc[first : first + hours]
    return {"time_s": np.arange(len(frame)) * HOUR, **{name: frame[column] for name, column in names.items()}}
