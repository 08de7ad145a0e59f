"""Reads files of the package calocem."""

import pandas as pd
from formats.text import csv


def cement_calorimeter(content, first, every=4):
    """Heat flow of eight channels of a calorimeter in mW, each so many rows, from a time in s on."""
    frame = csv(content, skiprows=[1, 2])
    frame = frame[frame.Zeit >= first].iloc[::every]
    return frame.assign(time_s=frame.Zeit - frame.Zeit.iloc[0])


def thermostat(content, first, every):
    """Room and bath of a calorimeter, each so many rows, from a time in s on."""
    lines = content.decode("utf-8").splitlines()
    start = next(k for k, line in enumerate(lines) if line.startswith('"Time"')) + 1
    cells = [line.split(",")[:4] for line in lines[start:] if line.count(",") >= 6]
    frame = pd.DataFrame(cells, columns=["time", "room", "bath", "heat"]).apply(pd.to_numeric, errors="coerce").dropna()
    frame = frame[(frame.time > first) & (frame.time.diff().fillna(1) > 0)].iloc[::every]
    return frame.assign(time_s=frame.time - frame.time.iloc[0])
