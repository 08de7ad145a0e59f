"""Gamma rays of rock that one tool tells over those that another one tells of the same well, each second foot."""

from formats.las import well_log
from models.bends import bends_with
from models.fitting import through_zero

HAND_BUILT = "line"


def rows(content):
    told = well_log(content).iloc[::4]
    return {"first_gapi": told.GR3, "second_gapi": told.GR}


def models(c):
    y, x = c["second_gapi"], c["first_gapi"]
    return y, {"as it is": lambda seen: x, "gain": through_zero(y, x), **bends_with(y, x)}
