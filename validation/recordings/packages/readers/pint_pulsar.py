"""Reads files of the package pint-pulsar."""

import re

import numpy as np


def telescope_clock(content, first, last):
    """A clock against another between two days (MJD): seconds since the first row, and how far it is ahead in us."""
    cells = [line.split() for line in content.decode("latin1").splitlines()]
    rows = np.array([[float(row[0]), float(row[2])] for row in cells if len(row) > 2 and re.fullmatch(r"\d+\.\d+", row[0])])
    rows = rows[(rows[:, 0] > first) & (rows[:, 0] < last)]
    return (rows[:, 0] - rows[0, 0]) * 86400, rows[:, 1]
