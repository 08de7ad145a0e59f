"""Reads files of the package aerosoltools."""

import pandas as pd
from formats.clock import seconds
from formats.text import csv


def partector(content):
    """A counter of fine particles, every fourth row: its columns by name."""
    lines = [row.split("\t") for row in content.decode("latin1").splitlines()]
    start = next(k for k, row in enumerate(lines) if row[0] == "time")
    return pd.DataFrame([[float(v) for v in row[:12]] for row in lines[start + 1 :] if len(row) >= 12], columns=lines[start][:12]).iloc[::4]


def impactor(content):
    """A low-pressure impactor, every fifth second: seconds and its columns by name, from the charger to its thermometers."""
    lines = content.decode("latin1").splitlines()
    start = next(k for k, row in enumerate(lines) if row.startswith("Date Time"))
    cells = [row.split(",") for row in lines[start + 1 :] if row[:1] == "2"][::5]
    frame = pd.DataFrame([[float(v) for v in row[17:32]] for row in cells], columns=lines[start].split(",")[17:32])
    return frame.assign(time_s=seconds([row[0] for row in cells]))


def soot(content):
    """A meter of soot on a filter, a row a minute, without its last row and those in which a colour said nothing."""
    frame = csv(content).iloc[:-1].dropna(subset=["UV BC1", "Red BC1"])
    return frame.assign(time_s=seconds(frame["Date / time local"]))
