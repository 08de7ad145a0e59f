"""Tables of a Campbell logger as text (TOA5)."""

from formats.text import csv


def toa5(content):
    """A logger's table below its four lines of heading."""
    return csv(content, skiprows=[0, 2, 3], na_values=["NAN"], low_memory=False)
