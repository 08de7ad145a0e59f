"""Reads files of the package gaitpy."""

import pandas as pd
from formats.clock import seconds
from formats.text import csv


def wrist_sensor(content, every):
    """How warm a wrist sensor is, each so many rows; seconds since the first."""
    frame = csv(content, skiprows=100, header=None).iloc[::every]
    return {"time_s": seconds(pd.to_datetime(frame[0], format="%Y-%m-%d %H:%M:%S:%f")), "sensor_degc": frame[6]}
