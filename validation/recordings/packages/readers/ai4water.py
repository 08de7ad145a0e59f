"""Reads files of the package AI4Water."""

import io

import pandas as pd
from formats.clock import since_first


def beach(content, *names):
    """Half hours of a beach; seconds since the first."""
    frame = pd.read_csv(io.BytesIO(content))
    when = pd.to_datetime(frame["index"], format="%m/%d/%Y %H:%M")
    return frame[list(names)].assign(time_s=since_first((when - when.iloc[0]).dt.total_seconds()))
