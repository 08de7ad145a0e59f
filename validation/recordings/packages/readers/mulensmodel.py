"""Reads files of the package mulensmodel."""

import pandas as pd
from durations import DAY
from formats.clock import since_first
from formats.text import csv


def two_fields(first, second, apart, worst):
    """Magnitudes of one star in two fields of a camera, of exposures that follow each other so soon; seconds since the first."""
    first, second = (csv(content, sep=r"\s+", header=None, usecols=[0, 1, 2], names=["day", "mag", "error"]) for content in (first, second))
    first, second = (frame[frame.error < worst].sort_values("day") for frame in (first, second))
    both = pd.merge_asof(second, first, on="day", direction="nearest", tolerance=apart / DAY, suffixes=("_2", "_1")).dropna()
    return {"time_s": (since_first(both.day) * DAY).round(1), "first_mag": both.mag_1, "second_mag": both.mag_2}
