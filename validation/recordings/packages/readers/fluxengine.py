"""Reads files of the package fluxengine."""

from formats.clock import seconds
from formats.text import csv


def cruise(content, first, last, **names):
    """Columns of a cruise from one row to another; seconds since the first."""
    frame = csv(content, sep="\t", parse_dates=["datetime"]).iloc[first:last]
    return {"time_s": seconds(frame.datetime), **{name: frame[column].to_numpy() for name, column in names.items()}}
