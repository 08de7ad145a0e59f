"""Reads files of the package hydrotoolbox."""

import pandas as pd
from formats.clock import seconds
from formats.text import csv

FOOT = 0.3048
SPRING = {"water_degc": ("00010", 1), "stage_m": ("00065", FOOT), "flow_m3_s": ("00060", FOOT**3), "oxygen_mg_l": ("00300", 1)}


def spring(content, *names, every=1):
    """Daily means of a spring's gauge, days that have all that is asked for; seconds since the first."""
    frame = csv(content, index_col=0, parse_dates=True)
    parameters = [column.split("_") for column in frame.columns]
    mean = {parts[3]: place for place, parts in enumerate(parameters) if parts[4].startswith("00003")}
    told = pd.DataFrame({name: frame.iloc[:, mean[SPRING[name][0]]] * SPRING[name][1] for name in names}).dropna().iloc[::every]
    return told.assign(time_s=seconds(told.index.to_series())).reset_index(drop=True)
