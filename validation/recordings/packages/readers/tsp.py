"""Reads files of the package tsp."""

import pandas as pd
from formats.clock import seconds
from formats.text import csv


def thermistor_string(content, rows=2100):
    """A logger of thermistors in the ground, each 8 hours: seconds, battery in V, ten thermometers from above to below, and that of the logger. Until it was dug out."""
    cells = [row.replace('"', "").split(",") for row in content.decode("latin1").splitlines() if row.startswith("20")][:rows]
    frame = pd.DataFrame([[float(row[k]) for k in (2, *range(3, 13), 26)] for row in cells], columns=["battery_v", *range(1, 11), "logger_c"])
    return frame.assign(time_s=seconds([row[0] for row in cells]))


def thermistors_on_bench(content):
    """Five thermistors of a logger on a bench, every fourth hour from the 2000th row on, with seconds since the first."""
    cells = [row.split(",") for row in content.decode("latin1").splitlines() if row[:1].isdigit()][2000::4]
    frame = pd.DataFrame([[float(v) for v in row[2:7]] for row in cells], columns=range(1, 6))
    return frame.assign(time_s=seconds(pd.to_datetime([row[1] for row in cells], format="%d.%m.%Y %H:%M:%S")))


def two_probes(content):
    """Two probes of a logger, every sixth hour from the second day on, with seconds since the first."""
    frame = csv(content, skiprows=1, encoding="utf-8-sig").iloc[:, [1, 2, 3, 4]]
    frame.columns = ["day", "hour", "first", "second"]
    frame = frame.dropna().iloc[24::6]
    return frame.assign(time_s=seconds(pd.to_datetime(frame.day + " " + frame.hour, format="%m/%d/%y %I:%M:%S %p")))


def logger_housing(content):
    """Inside of the housing of a logger, an hour a row from the second day on: temperature, pressure, humidity, battery, seconds."""
    frame = csv(content, skiprows=[1, 2, 3, 4, 5]).iloc[24:]
    return frame.assign(time_s=seconds(frame.timestamp))
