"""Reads files of the package gensor."""

import pandas as pd


def diver(content):
    """A water level logger (a diver) or its barometer: pressure in hPa, temperature, and the time of each row; lines that are not whole are left away."""
    lines = [line.split(",") for line in content.decode("latin1").splitlines() if line[:2] == "20"]
    frame = pd.DataFrame([line for line in lines if len(line) == 3], columns=["when", "pressure", "degc"])
    numbers = frame[["pressure", "degc"]].apply(pd.to_numeric, errors="coerce")
    return numbers.assign(when=pd.to_datetime(frame.when), pressure=numbers.pressure * 0.980665).dropna()


def wells(first, second, barometer):
    """Hours in which two divers, `_1` and `_2`, are under water and their barometer has a number."""
    both = diver(first).merge(diver(second), on="when", suffixes=("_1", "_2")).merge(diver(barometer), on="when")
    return both[(both.pressure_1 > 1080) & (both.pressure_2 > 1080)]
