"""Reads files of the package gtsam."""

import numpy as np
from formats.clock import elapsed
from formats.matlab import variables


def radio_ranges(content):
    """How far some radios are from a robot, by what it receives and by where it is, in the order of time; seconds since the first."""
    file = variables(content, squeeze_me=True)
    radios = {int(number): (east, north) for number, east, north in file["TL"]}
    at, _, number, told = file["TD"][np.unique(file["TD"][:, 0], return_index=True)[1]].T
    east, north = (np.interp(at, file["GT"][:, 0], file["GT"][:, k]) for k in (1, 2))
    places = np.array([radios[int(k)] for k in number])
    return {"time_s": elapsed(at), "apart_m": np.hypot(east - places[:, 0], north - places[:, 1]), "radio_m": told}
