"""Reads files of the package traffic."""

import gzip
import json

import pandas as pd


def flight(content):
    """Positions of an aircraft by time, from gzipped JSON: its numbers by name, and seconds since the first row."""
    cells = json.loads(gzip.decompress(content))
    frame = pd.DataFrame(cells).sort_values("timestamp").drop_duplicates("timestamp").reset_index(drop=True)
    return frame.assign(time_s=(frame.timestamp - frame.timestamp.iloc[0]) / 1000)
