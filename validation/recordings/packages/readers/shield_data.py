"""Reads files of the package shield-data."""

import numpy as np
from formats.clock import seconds
from formats.rows import means
from formats.text import csv

GAUGES = {"wire_v": "WGM701_Voltage (V)", "convection_v": "CVM211_Voltage (V)", "upper_v": "Baratron626D_1KT_Voltage (V)", "lower_v": "Baratron626D_1T_Voltage (V)"}


def permeation(content, every, *names, begin=0, lower=None):
    """Volts of some gauges of a rig in which hydrogen goes through a wall, means of so many rows, from a second on; `lower` holds the lower gauge between two volts. Seconds since the first mean."""
    frame = csv(content, parse_dates=["RealTimestamp"])
    t = seconds(frame.RealTimestamp)
    kept = t > begin
    if lower is not None:
        kept &= frame[GAUGES["lower_v"]].between(*lower, inclusive="neither").to_numpy()
    clock = means(t[kept], every)
    return {"time_s": np.round(clock - clock[0], 3), **{name: means(frame[GAUGES[name]].to_numpy()[kept], every) for name in names}}
