"""Reads files of the package libinsitu."""

import gzip

import pandas as pd
from formats.clock import seconds, since_first
from formats.text import csv


def radiation(content, first, last):
    """Minutes of a station for radiation from one day to before another: seconds since the first of them, beam, global and diffuse in W/m2, air in degC."""
    frame = csv(gzip.decompress(content)).dropna()
    when = pd.to_datetime(frame.date + " " + frame.time)
    frame = frame.assign(when=when, air_c=frame.temp - 273.15)[(when >= first) & (when < last)]
    return frame.assign(time_s=seconds(frame.when))


def clock_from_first_row(frame):
    """A frame whose clock begins at its first row."""
    return frame.assign(time_s=since_first(frame.time_s))
