"""Reads files of the package rigolwfm."""

import numpy as np


def scope(content):
    """Rows of an oscilloscope with two channels: seconds since the first, as the second row tells them, and both in V."""
    _, told, *lines = content.decode("latin1").splitlines()
    step = float(told.split(",")[4])
    rows = np.array([line.split(",")[1:3] for line in lines], float)
    return {"time_s": np.arange(len(rows)) * step, "first_v": rows[:, 0], "second_v": rows[:, 1]}
