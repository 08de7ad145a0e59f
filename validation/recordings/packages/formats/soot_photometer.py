"""What a soot photometer (SP2) tells of itself."""

import pandas as pd
from formats.rows import means
from formats.text import csv


def photometer(content, **names):
    """What a soot photometer tells of itself, a row a second: seconds of the day, and columns by the names that they are to have."""
    frame = csv(content, sep="\t", usecols=["Time (sec)", *names.values()])
    return pd.DataFrame({"time_s": frame["Time (sec)"], **{name: frame[column] for name, column in names.items()}})


def mean_rows(frame, rows):
    """Means of so many rows, and seconds since the first mean."""
    found = {name: means(column, rows) for name, column in frame.items()}
    return {**found, "time_s": (found["time_s"] - found["time_s"][0]).round(1)}
