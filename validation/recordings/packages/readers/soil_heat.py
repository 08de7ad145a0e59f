"""Reads files of the package soil-heat."""

import pandas as pd
from formats.clock import seconds
from formats.text import csv


def half_hours(content, *names):
    """Half hours of a station in which these columns have numbers, and seconds since the first."""
    frame = csv(content, na_values=["NAN"], low_memory=False)
    frame.columns = [name.strip('"') for name in frame.columns]
    when = pd.to_datetime(frame.TIMESTAMP_START.astype(str), format="%Y%m%d%H%M")
    frame = frame[list(names)].apply(pd.to_numeric, errors="coerce").assign(when=when).dropna()
    return frame.assign(time_s=seconds(frame.when))
