"""Reads files of the package aeroviz."""

from formats.clock import seconds
from formats.text import csv


def air_station(content, *names):
    """Hours of a station for the air with a number in each of the columns; seconds since the first hour of the table."""
    frame = csv(content, usecols=["Time", *names], parse_dates=["Time"])
    frame = frame.assign(time_s=seconds(frame.Time))
    return frame.dropna()
