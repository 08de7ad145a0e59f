"""Reads files of the package seagliderog1."""

import numpy as np
from formats.clock import since_first
from formats.netcdf import netcdf

GLIDER = {"TIME": "time", "PRES": "pressure", "ROLL": "roll", "ROLL_CTL": "battery", "TEMP": "water", "eng_aa4330_Temp": "optode", "divenum": "dive"}
WATER = {"time": "legato_time", "pressure": "legato_pressure", "water": "legato_temp", "cell": "legato_conducTemp"}


def polar_glider(content):
    """Rows of the thermometer and of the cell for conductivity of a glider below 1 dbar, and seconds since the first."""
    frame = netcdf(content, WATER)
    frame = frame[frame.pressure > 1]
    return frame.assign(time_s=since_first(frame.time).round(3))


def oxygen_thermometer(content):
    """Rows of a sensor for oxygen on the same glider, by its own clock: its thermometer, and that of the water at its times, straight between rows."""
    water = netcdf(content, WATER)
    frame = netcdf(content, {"time": "codaTODO_time", "foil": "codaTODO_temp"})
    frame = frame.assign(**{name: np.interp(frame.time, water.time, water[name]) for name in ("pressure", "water")})
    frame = frame[frame.pressure > 1]
    return frame.assign(time_s=since_first(frame.time).round(3))


def warm_glider(content, first, last, deeper, *names):
    """Rows of dives of a glider in warm water, from one dive to another, deeper than so many dbar, with a number in these columns; seconds since the first."""
    frame = netcdf(content, {short: name for name, short in GLIDER.items()}).dropna(subset=["pressure", *names])
    frame = frame[(frame.dive >= first) & (frame.dive <= last) & (frame.pressure > deeper)]
    return frame.assign(time_s=since_first(frame.time).round(3))
