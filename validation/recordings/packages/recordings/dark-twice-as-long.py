"""Counts of a spectrometer in the dark after 4 s over those after 2 s, a pixel a row, and those after 3 ms. What a pixel tells at once does not grow with the time."""

from models.drivers import of_drivers
from models.fitting import line
from readers.luxpy import darkness

HAND_BUILT = "square, and slope by short"


def rows(content):
    short, half, whole = darkness(content, 0.003, 2, 4)
    return {"short_counts": short, "half_counts": half, "whole_counts": whole}


def models(c):
    y, x, short = c["whole_counts"], c["half_counts"], c["short_counts"]
    return y, {**of_drivers(y, x, short=short), "twice, less short": lambda seen: 2 * x - short, "pixel": line(y, x, range(len(y)))}
