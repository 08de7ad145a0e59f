"""Reads files of the package scraps."""

import io
import re
import zipfile

import numpy as np
import pandas as pd
from formats.text import matrix

TRACE = re.compile(r"ExampleData/RES-(\d)_(-\d+)_DBM_TEMP_([\d.]+)\.S2P")
NEAR = 15


def traces(content, resonator, powers):
    """Traces of a resonator in the order in which they were measured: seconds, power in dBm, temperature in K, frequency in Hz, transmission."""
    with zipfile.ZipFile(io.BytesIO(content)) as file:
        found = [(TRACE.fullmatch(one.filename), one) for one in file.infolist()]
        found = [(told, one) for told, one in found if told and int(told[1]) == resonator and int(told[2]) in powers]
        found = sorted(found, key=lambda pair: (pair[1].date_time, int(pair[0][2])))
        start = pd.Timestamp(*found[0][1].date_time)
        for told, one in found:
            hertz, real, imaginary = matrix(file.read(one), skiprows=1).T
            yield (pd.Timestamp(*one.date_time) - start).total_seconds(), int(told[2]), float(told[3]), hertz, np.hypot(real, imaginary)


def resonance(hertz, passed):
    """Frequency at which a resonator lets least through: the foot of a parabola through the square of the transmission around its smallest."""
    foot = int(np.argmin(passed))
    near = slice(max(foot - NEAR, 0), foot + NEAR + 1)
    square, slope, _ = np.polyfit(hertz[near] - hertz[foot], passed[near] ** 2, 2)
    return hertz[foot] - slope / 2 / square
