"""Reads files of the package fluxpart."""

import numpy as np
from formats.text import csv


def eddy_station(content):
    """The first 6000 rows, five minutes, of an anemometer and a gas analyser that are read 20 times a second."""
    frame = csv(content, skiprows=[0, 2, 3]).iloc[:6000]
    return frame.assign(time_s=np.arange(len(frame)) / 20)
