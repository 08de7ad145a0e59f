"""Reads files of the package pyglider."""

import pandas as pd
from formats.clock import seconds
from formats.packed import unpacked
from formats.text import csv


def glider(*contents):
    """Tables of a glider that is driven by its own clock, one after another, rows in which the clock went on, and seconds since the first; packed ones are unpacked."""
    frame = pd.concat([csv(unpacked(content), sep=";") for content in contents], ignore_index=True)
    when = pd.to_datetime(frame.iloc[:, 0], dayfirst=True, format="mixed")
    frame = frame.assign(time_s=seconds(when))
    return frame[frame.time_s.diff().fillna(1) > 0]
