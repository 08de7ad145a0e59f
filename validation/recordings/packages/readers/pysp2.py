"""Reads files of the package pysp2."""

import io

import pandas as pd
from formats.rows import means


def photometer(content, **names):
    """What a soot photometer tells of itself, a row a second: seconds of the day, and columns by the names that they are to have."""
    frame = pd.read_csv(io.BytesIO(content), sep="\t", usecols=["Time (sec)", *names.values()])
    return pd.DataFrame({"time_s": frame["Time (sec)"], **{name: frame[column] for name, column in names.items()}})


def half_minutes(frame):
    """Means of 30 rows, and seconds since the first mean."""
    found = {name: means(column, 30) for name, column in frame.items()}
    return {**found, "time_s": (found["time_s"] - found["time_s"][0]).round(1)}
