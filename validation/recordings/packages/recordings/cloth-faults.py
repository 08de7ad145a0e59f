"""Faults counted in 32 rolls of cloth over their length: in proportion, with scatter that grows with the count."""

from models.fitting import line, through_zero
from readers.rdatasets import frame

HAND_BUILT = "line"


def rows(content):
    d = frame(content)
    return {"length_100m": d.x, "faults": d.y}


def models(c):
    y, x = c["faults"], c["length_100m"]
    return y, {HAND_BUILT: line(y, x), "proportion": through_zero(y, x), "square": line(y, x, x**2)}
