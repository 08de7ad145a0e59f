"""Reads files of the package oceanarray."""

import pandas as pd
from formats.clock import seconds
from formats.text import csv


def aquadopp(content, every=4):
    """Rows of a current meter while it is moored, each so many, by the number of its column, from one on; seconds since the first."""
    frame = csv(content, sep=r"\s+", header=None)
    frame.columns += 1
    frame = frame.iloc[150:9900]
    at = pd.to_datetime({"year": frame[3], "month": frame[1], "day": frame[2], "hour": frame[4], "minute": frame[5], "second": frame[6]})
    return frame.assign(time_s=seconds(at)).iloc[::every]
