"""Gamma rays of rock that one tool tells over those that another one tells of the same well, each second foot."""

from fitting import through_zero
from monitors import bends_with
from reading import well_log

HAND_BUILT = "line"


def rows(content):
    told = well_log(content).iloc[::4]
    return {"first_gapi": told.GR3, "second_gapi": told.GR}


def models(c):
    y, x = c["second_gapi"], c["first_gapi"]
    return y, {"as it is": lambda seen: x, "gain": through_zero(y, x), **bends_with(y, x)}
