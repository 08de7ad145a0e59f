"""Reads files of the package pyglider."""

import gzip

import pandas as pd
from formats.clock import seconds
from formats.text import csv


def glider(*contents):
    """Tables of a glider that is driven by its own clock, one after another, rows in which the clock went on, and seconds since the first; packed ones are unpacked."""
    plain = [gzip.decompress(content) if content[:2] == b"\x1f\x8b" else content for content in contents]
    frame = pd.concat([csv(content, sep=";") for content in plain], ignore_index=True)
    when = pd.to_datetime(frame.iloc[:, 0], dayfirst=True, format="mixed")
    frame = frame.assign(time_s=seconds(when))
    return frame[frame.time_s.diff().fillna(1) > 0]
