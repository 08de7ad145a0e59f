"""Gravity by an instrument in a plane along a line that was flown ten times: each of the other nine over the first, at the same places."""

import numpy as np
from models.bends import bends_with
from models.fitting import line, scaled
from readers.galileoqc import flown_again

HAND_BUILT = "line"


def rows(content):
    return flown_again(content, 5, "FA100s_GRS80")


def models(c):
    y, x, run = c["again_mgal"], c["first_mgal"], c["run"]
    w, each = scaled(run), [run == k for k in np.unique(run)[1:]]
    return y, {
        "as it is": lambda seen: x,
        "zero": lambda seen: x + np.mean((y - x)[seen]),
        **bends_with(y, x),
        "number": line(y, x, w),
        "slope by number": line(y, x, w, scaled(x) * w),
        "way to the west": line(y, x, np.isin(run, [1, 3, 5, 7, 8])),
        "zero of each run": line(y, x, *each),
        "slope of each run": line(y, x, *(x * one for one in each)),
    }
