"""Reads files of the package sp00kyvectors."""

import pandas as pd
from formats.clock import seconds
from formats.text import csv

PLAUSIBLE = {"BME680_Temp": (10, 45), "Temp_LSM9DS1": (10, 45), "Pressure": (990, 1040), "Humidity": (10, 95)}
MINUTE = len("2025-05-06T00:00")


def sensor_box(content, days, least=None, **names):
    """Medians of a minute of a box of sensors in some days, minutes whose air is plausible; `least` is a column and what it has to be more than. Seconds since the first."""
    frame = csv(content, dtype={"Timestamp": str})
    frame = frame[frame.Timestamp.str.fullmatch(days + r"T\d\d:\d\d:\d\d", na=False)]
    frame = frame.groupby(frame.Timestamp.str[:MINUTE]).median(numeric_only=True)
    for column, (low, high) in PLAUSIBLE.items():
        frame = frame[frame[column].between(low, high)]
    if least is not None:
        frame = frame[frame[least[0]] > least[1]]
    return {"time_s": seconds(pd.to_datetime(frame.index.to_series())), **{name: frame[column].to_numpy() for name, column in names.items()}}
