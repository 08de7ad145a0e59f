"""Reads files of the package pvops."""

from formats.clock import seconds
from formats.text import csv


def solar_plant(content, plant, every):
    """Hours of day at one plant, each so many: seconds since the first, and the columns by their name."""
    frame = csv(content, parse_dates=["date"])
    frame = frame[frame.randid == plant].dropna().iloc[::every]
    return frame.assign(time_s=seconds(frame.date))
