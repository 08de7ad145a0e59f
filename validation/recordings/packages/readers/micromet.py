"""Reads files of the package micromet."""

import re

import numpy as np
import pandas as pd

TOB1_KINDS = {"ULONG": "<u4", "LONG": "<i4", "IEEE4": "<f4"}


def tob1(content):
    """A table of a logger in its own packed form (TOB1): numbers by name, and seconds since the first row."""
    lines = content.split(b"\r\n", 5)
    names, kinds = ([word.strip('"') for word in line.decode().split(",")] for line in (lines[1], lines[4]))
    row = np.dtype([(name, TOB1_KINDS.get(kind) or "S" + re.search(r"\d+", kind)[0]) for name, kind in zip(names, kinds)])
    table = np.frombuffer(lines[5], row, len(lines[5]) // row.itemsize)
    frame = pd.DataFrame({name: table[name].astype(float) for name, kind in zip(names, kinds) if kind in TOB1_KINDS})
    return frame.assign(time_s=frame.SECONDS - frame.SECONDS.iloc[0])
