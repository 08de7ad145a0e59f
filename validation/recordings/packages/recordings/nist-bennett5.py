"""Magnetisation of a superconductor over the logarithm of time; the model is the certified one of NIST."""

from formats.nist import nist
from models.fitting import curve, line

HAND_BUILT = "b1 (b2 + x)^(-1/b3)"


def rows(content):
    return nist(content, ["magnetization", "log_time"])


def models(c):
    y, x = c["magnetization"], c["log_time"]
    power = curve(y, lambda p: p[0] * (p[1] + x) ** (-1 / p[2]), [-2523, 46.7, 0.932])
    return y, {"line": line(y, x), HAND_BUILT: power}
