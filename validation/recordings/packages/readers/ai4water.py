"""Reads files of the package AI4Water."""

import pandas as pd
from formats.clock import seconds
from formats.text import csv


def beach(content, *names):
    """Half hours of a beach; seconds since the first."""
    frame = csv(content)
    when = pd.to_datetime(frame["index"], format="%m/%d/%Y %H:%M")
    return frame[list(names)].assign(time_s=seconds(when))
