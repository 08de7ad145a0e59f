"""Reads files of the package sunpeek-exampledata."""

import pandas as pd
from formats.clock import seconds
from formats.text import csv


def collectors(content, first, last, every):
    """Rows of a field of solar collectors from one time to another, one of `every` minutes, with seconds since the first."""
    frame = csv(content, sep=";")
    when = pd.to_datetime(frame.timestamps_UTC)
    frame = frame.assign(when=when)[(when >= first) & (when < last)].iloc[::every].dropna()
    return frame.assign(time_s=seconds(frame.when))
