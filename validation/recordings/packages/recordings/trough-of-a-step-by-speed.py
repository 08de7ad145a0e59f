"""Trough of the force under a foot between its two peaks over the speed of the walker, ten walkers of sixty steps each, a run a walker. Whoever walks faster is lifted more; people differ."""

from dials import steps
from fitting import line
from monitors import bends_with

HAND_BUILT = "line"


def rows(speeds, *contents):
    return steps(contents, speeds, between=(30, 70))


def models(c):
    y, x, run = c["trough"], c["speed_m_s"], c["run"]
    walkers = [(run == k) * 1.0 for k in range(2, 11)]
    return y, {
        **bends_with(y, x),
        "a constant each": line(y, x, *walkers),
        "a constant each, and square": line(y, x, x**2, *walkers),
        "a line each": line(y, x, *walkers, *(x * one for one in walkers)),
    }
