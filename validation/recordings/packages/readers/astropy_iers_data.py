"""Reads files of the package astropy-iers-data."""

import numpy as np


def earth_orientation(content, first, days, name):
    """Seconds since a modified Julian date, and one column of the Earth's orientation by the day: `X`, `UT1` or `LOD`."""
    lines = [line.split() for line in content.decode().splitlines() if line[:1] != "#"]
    table = np.array([[float(v) for v in line[:13]] for line in lines])
    kept = table[(table[:, 4] >= first) & (table[:, 4] < first + days)]
    return (kept[:, 4] - first) * 86400, kept[:, {"X": 5, "UT1": 7, "LOD": 12}[name]]
