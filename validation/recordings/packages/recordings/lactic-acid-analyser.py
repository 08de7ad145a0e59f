"""Readings of an instrument for lactic acid in blood at five known concentrations: a straight line, with scatter that grows a little."""

from models.fitting import line
from readers.rdatasets import frame

HAND_BUILT = "line"


def rows(content):
    d = frame(content)
    return {"lactic_acid": d.X, "reading": d.Y}


def models(c):
    y, x = c["reading"], c["lactic_acid"]
    return y, {HAND_BUILT: line(y, x), "square": line(y, x, x**2)}
