"""Readings of a customer's ozone monitor against that of the standards office: a straight line is the certified model."""

from formats.nist import nist
from models.fitting import line, terms

HAND_BUILT = "line"


def rows(content):
    found = nist(content, ["monitor", "reference"])
    return {"reference_ppb": found["reference"], "monitor_ppb": found["monitor"]}


def models(c):
    y, x = c["monitor_ppb"], c["reference_ppb"]
    return y, {HAND_BUILT: line(y, x), "square": line(y, x, x**2), "power": terms(y, lambda p: [x ** p[0]], [1.0])}
