"""Reads files of the package ISLP."""

from durations import HOUR
from formats.text import csv


def cars(content):
    """Cars in the order of their years: their weight, the year, and how far they go with a gallon."""
    frame = csv(content, sep=r"\s+")
    return {"weight_lb": frame.weight, "year": frame.year + 1900, "miles_gallon": frame.mpg}


def riders(content, first, rows):
    """Bicycles that were lent to those who come now and then and to those who are on a list, so many hours from one on; seconds since the first."""
    frame = csv(content).iloc[first : first + rows]
    hours = (frame.day - frame.day.iloc[0]) * 24 + frame.hr - frame.hr.iloc[0]
    return {"time_s": hours * HOUR, "casual": frame.casual, "registered": frame.registered}
