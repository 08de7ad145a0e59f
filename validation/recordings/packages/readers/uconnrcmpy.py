"""Reads files of the package UConnRCMPy."""

import numpy as np
from formats.rows import means
from formats.text import matrix


def shot(content):
    """Seconds and volts of a gauge, two columns without a head."""
    return matrix(content).T


def two_shots(*contents, first, last, every):
    """What the gauge of a machine that compresses gas told at two shots, each so many rows of a stretch: seconds since its first row, and volts of either."""
    (time, one), (_, other) = (shot(content)[:, first:last:every] for content in contents)
    return {"time_s": np.round(time - time[0], 6), "first_v": one, "second_v": other}


def slow_shots(*contents, begin, rows):
    """Means of so many rows of shots, from some second on: seconds since the first mean, and volts of each shot."""
    tables = [shot(content) for content in contents]
    time, *volts = (means(values, rows) for values in (tables[0][0], *(told for _, told in tables)))
    kept = time > begin
    return {"time_s": np.round(time[kept] - time[kept][0], 6), **{f"{name}_v": np.round(told[kept], 9) for name, told in zip(("first", "second"), volts)}}
