"""Lengths of strides by sensors that are worn over those by cameras, three people in a laboratory."""

import numpy as np
from models.bends import bends_with, corner
from models.fitting import line
from readers.mobgap import strides

HAND_BUILT = "square"


def rows(*contents):
    return strides(*contents, apart=0.12)


def models(c):
    y, x = c["worn_m"], c["cameras_m"]
    return y, {"as it is": lambda seen: x, "zero": lambda seen: x + np.mean((y - x)[seen]), **bends_with(y, x), "corner": corner(y, x, 0.6), "logarithm": line(y, np.log(x))}
