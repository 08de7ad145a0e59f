"""Trough of the force under a foot between its two peaks over the speed of the walker, ten walkers of sixty steps each, a run a walker. Whoever walks faster is lifted more; people differ."""

from models.bends import bends_with
from models.fitting import line
from readers.spm1d import steps_on_treadmill

HAND_BUILT = "line"


def rows(speeds, *contents):
    return steps_on_treadmill(contents, speeds, between=(30, 70))


def models(c):
    y, x, run = c["trough"], c["speed_m_s"], c["run"]
    walkers = [(run == k) * 1.0 for k in range(2, 11)]
    return y, {
        **bends_with(y, x),
        "a constant each": line(y, x, *walkers),
        "a constant each, and square": line(y, x, x**2, *walkers),
        "a line each": line(y, x, *walkers, *(x * one for one in walkers)),
    }
