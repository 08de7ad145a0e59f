"""Reads files of the package fluxpart."""

import numpy as np
from formats.toa5 import toa5


def eddy_station(content):
    """The first 6000 rows, five minutes, of an anemometer and a gas analyser that are read 20 times a second."""
    frame = toa5(content).iloc[:6000]
    return frame.assign(time_s=np.arange(len(frame)) / 20)
