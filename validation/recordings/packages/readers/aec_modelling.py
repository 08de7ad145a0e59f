"""Reads files of the package aec-modelling."""

import numpy as np
from formats.clock import seconds
from formats.text import csv

KELVIN = 273.15


def stack(content):
    """A stack that splits water, by the minute in the order of the clock: current by its hydrogen, warmth, volts of a cell."""
    frame = csv(content, parse_dates=["time"]).sort_values("time", kind="stable")
    return {"time_s": seconds(frame.time), **cell_columns(frame)}


def cell_columns(frame):
    """Current, warmth and volts of a cell."""
    return {"current_ma_cm2": frame.j, "warmth_degc": np.round(frame["T"] - KELVIN, 4), "volts": frame.V}
