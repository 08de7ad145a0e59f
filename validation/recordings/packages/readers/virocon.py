"""Reads files of the package virocon."""

import pandas as pd
from formats.clock import seconds
from formats.text import csv


def buoy(content, every):
    """How high the waves at a buoy are, and how long they last, each so many rows; seconds since the first."""
    frame = csv(content, sep=";", skipinitialspace=True).iloc[::every]
    height, period = (frame.iloc[:, k] for k in (1, 2))
    return {"time_s": seconds(pd.to_datetime(frame.iloc[:, 0], format="%Y-%m-%d-%H")), "height_m": height, "period_s": period}
