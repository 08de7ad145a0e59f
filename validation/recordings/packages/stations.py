"""Formats of the twelfth set, from bytes to columns (the others are in reading.py, instruments.py, rigs.py and loggers.py)."""

import io
import zipfile

import numpy as np
import pandas as pd
from loggers import since
from reading import csv

SECONDS = {"minutes": 60, "hours": 3600, "days": 86400}


def toa5(content):
    """A logger's table below its four lines of heading."""
    return csv(content, skiprows=[0, 2, 3], na_values=["NAN"], low_memory=False)


def logger(content, *names):
    """Columns of a logger's table with its four lines of heading, rows with a number in each, and seconds since the first."""
    frame = toa5(content)[["TIMESTAMP", *names]].dropna().reset_index(drop=True)
    return frame.assign(time_s=since(frame.TIMESTAMP))


def tried_in_town(content, *names):
    """A station that is tried in a town before it goes to the ice: every second row since its upper level runs, without those in which a thermometer told 7999."""
    frame = logger(content, "Asp_temp_U", "TemperatureRadSensor", *names)
    frame = frame[frame.TemperatureRadSensor < 100].iloc[50::2]
    return frame.assign(time_s=frame.time_s - frame.time_s.iloc[0])


def compared(content, member):
    """What was measured and what a model says at one place, by name, and seconds since the first row."""
    from netCDF4 import Dataset

    with zipfile.ZipFile(io.BytesIO(content)) as archive, Dataset("place", memory=archive.read(member)) as data:
        found = {name: np.ma.filled(one[:].astype(float), np.nan) for name, one in data.variables.items() if one.dimensions == ("time",)}
        unit = data["time"].units.split()[0]
    return {**found, "time_s": (found["time"] - found["time"][0]) * SECONDS[unit]}


def moisture(content, first, last):
    """Soil moisture between two times, and seconds since the first row."""
    cells = [row.split() for row in content.decode().splitlines()]
    frame = pd.DataFrame({"time": pd.to_datetime([" ".join(row[:2]) for row in cells]), "moisture": [float(row[12]) for row in cells]})
    frame = frame[frame.time.between(first, last)]
    return frame.assign(time_s=since(frame.time))


def bare_plates(content, *names):
    """Columns of two force plates with nothing on them, every second reading of a minute, and seconds since the first."""
    frame = csv(content, sep="\t", usecols=["TimeStamp", *names]).iloc[::2]
    return frame.assign(time_s=frame.TimeStamp - frame.TimeStamp.iloc[0])
