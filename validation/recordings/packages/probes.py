"""Formats of the seventeenth set, from bytes to columns, and the models that four of it share (the others are in reading.py, instruments.py, rigs.py, loggers.py, stations.py, housekeeping.py, benches.py, receivers.py and recorders.py)."""

import io
import warnings

import numpy as np
import pandas as pd
from fitting import line, tone
from reading import netcdf
from rigs import since

YEAR = 365.2425 * 86400
GLIDER = {"TIME": "time", "PRES": "pressure", "ROLL": "roll", "ROLL_CTL": "battery", "TEMP": "water", "eng_aa4330_Temp": "optode", "divenum": "dive"}
WATER = {"time": "legato_time", "pressure": "legato_pressure", "water": "legato_temp", "cell": "legato_conducTemp"}


def polar_glider(content):
    """Rows of the thermometer and of the cell for conductivity of a glider below 1 dbar, and seconds since the first."""
    frame = netcdf(content, WATER)
    frame = frame[frame.pressure > 1]
    return frame.assign(time_s=since(frame.time).round(3))


def oxygen_thermometer(content):
    """Rows of a sensor for oxygen on the same glider, by its own clock: its thermometer, and that of the water at its times, straight between rows."""
    water = netcdf(content, WATER)
    frame = netcdf(content, {"time": "codaTODO_time", "foil": "codaTODO_temp"})
    frame = frame.assign(**{name: np.interp(frame.time, water.time, water[name]) for name in ("pressure", "water")})
    frame = frame[frame.pressure > 1]
    return frame.assign(time_s=since(frame.time).round(3))


def warm_glider(content, first, last, deeper, *names):
    """Rows of dives of a glider in warm water, from one dive to another, deeper than so many dbar, with a number in these columns; seconds since the first."""
    frame = netcdf(content, {short: name for name, short in GLIDER.items()}).dropna(subset=["pressure", *names])
    frame = frame[(frame.dive >= first) & (frame.dive <= last) & (frame.pressure > deeper)]
    return frame.assign(time_s=since(frame.time).round(3))


def detector(content, begin=0):
    """Rows of the days on which the time of the first detector of a station against the second was found, from one of them on: seconds since then, and that time in ns."""
    table = np.loadtxt(io.BytesIO(content))
    table = table[np.isfinite(table[:, 1])][begin:]
    return {"time_s": since(table[:, 0]), "late_ns": table[:, 1]}


def detector_models(c):
    """Its reading, and what is tried for it."""
    return c["late_ns"], drifts(c["late_ns"], c["time_s"])


def car(content):
    """Seconds of a car on rollers, from the first of its tests in a workbook, by the names of the second row."""
    import openpyxl  # the other readers do without it

    with warnings.catch_warnings(action="ignore"):  # of colours of cells
        book = openpyxl.load_workbook(io.BytesIO(content), read_only=True, data_only=True)
        told = list(book["WLTP-H"].iter_rows(values_only=True))
    frame = pd.DataFrame(told[2:], columns=told[1])
    return frame.loc[:, [name is not None for name in frame.columns]].dropna(axis=1, how="all").dropna(how="all").astype(float)


def cone(content, deepest):
    """Rows of a cone that is pushed into the ground, one each 0.02 m, from where its sleeve is in the ground on: depth in m, resistance and friction in MPa."""
    rows = [line.split() for line in content.decode("latin1").splitlines()]
    table = np.array([row for row in rows if len(row) == 10 and row[0].isdigit()], float)
    table = table[(table[:, 1] > 0.1) & (table[:, 1] <= deepest)]
    return {"depth_m": table[:, 1], "cone_mpa": table[:, 3], "sleeve_mpa": table[:, 6]}


def scope(content):
    """Rows of an oscilloscope with two channels: seconds since the first, as the second row tells them, and both in V."""
    _, told, *lines = content.decode("latin1").splitlines()
    step = float(told.split(",")[4])
    rows = np.array([line.split(",")[1:3] for line in lines], float)
    return {"time_s": np.arange(len(rows)) * step, "first_v": rows[:, 0], "second_v": rows[:, 1]}


def drifts(y, t):
    """What is tried where nothing is recorded but a clock: a drift, its square, a year, and a step where it takes most."""
    halves = [np.var(y[:k]) * k + np.var(y[k:]) * (len(y) - k) for k in range(10, len(y) - 10)]
    step = (np.arange(len(y)) >= 10 + int(np.argmin(halves))).astype(float)
    year = tone(t, YEAR)
    return {
        "constant": line(y),
        "drift": line(y, t),
        "drift, and its square": line(y, t, t**2),
        "year": line(y, *year),
        "year, and half a year": line(y, *year, *tone(t, YEAR / 2)),
        "year, and drift": line(y, *year, t),
        "step": line(y, step),
        "step, and drift": line(y, step, t),
        "step, and a drift before and after": line(y, step, t, step * t),
        "step, and year": line(y, step, *year),
    }
