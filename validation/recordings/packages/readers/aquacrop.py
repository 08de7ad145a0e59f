"""Reads files of the package aquacrop."""

import pandas as pd
from formats.clock import seconds
from formats.text import csv


def evaporation(content, begin, end, every):
    """Warmest of each day and what grass would evaporate on it, from a year to before another, each so many days; seconds since the first."""
    frame = csv(content, sep=r"\s+").rename(columns={"Day": "day", "Month": "month", "Year": "year"})
    frame = frame[(frame.year >= begin) & (frame.year < end)].iloc[::every]
    return {"time_s": seconds(pd.to_datetime(frame[["year", "month", "day"]])), "warmest_degc": frame["Tmax(C)"], "evaporation_mm": frame["Et0(mm)"]}
