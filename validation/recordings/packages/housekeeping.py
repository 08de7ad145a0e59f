"""Formats of the thirteenth set, from bytes to columns (the others are in reading.py, instruments.py, rigs.py, loggers.py and stations.py)."""

import gzip
import io
import re

import numpy as np
import pandas as pd
from loggers import since
from reading import csv, means

TOB1_KINDS = {"ULONG": "<u4", "LONG": "<i4", "IEEE4": "<f4"}


def photometer(content, **names):
    """What a soot photometer tells of itself, a row a second: seconds of the day, and columns by the names that they are to have."""
    frame = pd.read_csv(io.BytesIO(content), sep="\t", usecols=["Time (sec)", *names.values()])
    return pd.DataFrame({"time_s": frame["Time (sec)"], **{name: frame[column] for name, column in names.items()}})


def half_minutes(frame):
    """Means of 30 rows, and seconds since the first mean."""
    found = {name: means(column, 30) for name, column in frame.items()}
    return {**found, "time_s": (found["time_s"] - found["time_s"][0]).round(1)}


def glider(*contents):
    """Tables of a glider that is driven by its own clock, one after another, rows in which the clock went on, and seconds since the first; packed ones are unpacked."""
    plain = [gzip.decompress(content) if content[:2] == b"\x1f\x8b" else content for content in contents]
    frame = pd.concat([csv(content, sep=";") for content in plain], ignore_index=True)
    when = pd.to_datetime(frame.iloc[:, 0], dayfirst=True, format="mixed")
    frame = frame.assign(time_s=since(when))
    return frame[frame.time_s.diff().fillna(1) > 0]


def half_hours(content, *names):
    """Half hours of a station in which these columns have numbers, and seconds since the first."""
    frame = csv(content, na_values=["NAN"], low_memory=False)
    frame.columns = [name.strip('"') for name in frame.columns]
    when = pd.to_datetime(frame.TIMESTAMP_START.astype(str), format="%Y%m%d%H%M")
    frame = frame[list(names)].apply(pd.to_numeric, errors="coerce").assign(when=when).dropna()
    return frame.assign(time_s=since(frame.when))


def tob1(content):
    """A table of a logger in its own packed form (TOB1): numbers by name, and seconds since the first row."""
    lines = content.split(b"\r\n", 5)
    names, kinds = ([word.strip('"') for word in line.decode().split(",")] for line in (lines[1], lines[4]))
    row = np.dtype([(name, TOB1_KINDS.get(kind) or "S" + re.search(r"\d+", kind)[0]) for name, kind in zip(names, kinds)])
    table = np.frombuffer(lines[5], row, len(lines[5]) // row.itemsize)
    frame = pd.DataFrame({name: table[name].astype(float) for name, kind in zip(names, kinds) if kind in TOB1_KINDS})
    return frame.assign(time_s=frame.SECONDS - frame.SECONDS.iloc[0])


def clock(content, first, last):
    """A clock against another between two days (MJD): seconds since the first row, and how far it is ahead in us."""
    cells = [line.split() for line in content.decode("latin1").splitlines()]
    rows = np.array([[float(row[0]), float(row[2])] for row in cells if len(row) > 2 and re.fullmatch(r"\d+\.\d+", row[0])])
    rows = rows[(rows[:, 0] > first) & (rows[:, 0] < last)]
    return (rows[:, 0] - rows[0, 0]) * 86400, rows[:, 1]
