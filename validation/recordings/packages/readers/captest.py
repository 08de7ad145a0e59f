"""Reads files of the package captest."""

from formats.clock import seconds
from formats.text import csv


def solar_plant(content):
    """Rows of a solar plant, five minutes each, that have a number in every column, with seconds since the first."""
    frame = csv(content, index_col=0, parse_dates=True).dropna()
    return frame.assign(time_s=seconds(frame.index))
