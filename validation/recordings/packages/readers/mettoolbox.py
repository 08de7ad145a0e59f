"""Reads files of the package mettoolbox."""

import gzip

from formats.clock import seconds
from formats.text import csv


def thermometers(content, first, second, begin, end, every=1):
    """What thermometers at two places told each day, in degC."""
    frame = csv(content, encoding="utf-8-sig", index_col=0, parse_dates=True).loc[begin:end].iloc[::every]
    return {"time_s": seconds(frame.index.to_series()), "there_degc": (frame[first] - 32) / 1.8, "here_degc": (frame[second] - 32) / 1.8}


def weather_hours(content, begin, end):
    """Hours of a weather station between two dates: warmth, sun, and humidity; seconds since the first."""
    frame = csv(gzip.decompress(content), index_col=0, parse_dates=True).loc[begin:end].dropna()
    return {"time_s": seconds(frame.index.to_series()), "air_degc": frame.temp, "sun_w_m2": frame["glob"], "humidity_percent": frame.hum}
