"""Reads files of the package hesseflux."""

import pandas as pd
from formats.clock import seconds
from formats.text import csv


def tower(content, first, last, *names):
    """Half hours of a tower from one day to before another, in which these columns have numbers, and seconds since the first."""
    frame = csv(content, usecols=["TIMESTAMP_END", *names], na_values=["-9999", "-9999.0000"])
    when = pd.to_datetime(frame.TIMESTAMP_END.astype(str), format="%Y%m%d%H%M")
    frame = frame.assign(when=when)[(when >= first) & (when < last)].dropna()
    return frame.assign(time_s=seconds(frame.when))
