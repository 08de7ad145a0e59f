"""Reads files of the package gaitanalysistoolkit."""

from formats.text import csv


def bare_plates(content, *names):
    """Columns of two force plates with nothing on them, every second reading of a minute, and seconds since the first."""
    frame = csv(content, sep="\t", usecols=["TimeStamp", *names]).iloc[::2]
    return frame.assign(time_s=frame.TimeStamp - frame.TimeStamp.iloc[0])
