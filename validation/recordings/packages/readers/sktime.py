"""Reads files of the package sktime."""

from formats.clock import seconds
from formats.text import csv


def solar_half_hours(content):
    """What a country's solar cells gave, each half an hour; seconds since the first."""
    frame = csv(content, parse_dates=["datetime_gmt"])
    return {"time_s": seconds(frame.datetime_gmt), "solar": frame.solar_gen}
