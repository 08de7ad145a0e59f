"""Deuterium in water of the sea over heavy oxygen in it, as one laboratory told both of 21 cruises in six years, means of what was taken at one time. One of its scales drifts."""

from durations import YEAR
from models.cycles import tone
from models.fitting import line, terms
from models.jumps import soft_step
from readers.envgeo_seawater import casts

HAND_BUILT = "drift"


def rows(content):
    read = casts(content, "Kitajima", "d18O", "dD")
    return {"time_s": read.time_s, "oxygen_permille": read.d18O, "deuterium_permille": read.dD}


def models(c):
    y, x, t = c["deuterium_permille"], c["oxygen_permille"], c["time_s"] / YEAR
    after = lambda p: soft_step(t, p, 0.02)
    return y, {
        "line": line(y, x),
        "square": line(y, x, x**2),
        "cube": line(y, x, x**2, x**3),
        "drift": line(y, x, t),
        "drift, and its square": line(y, x, t, t**2),
        "slope that drifts": line(y, x, t, x * t),
        "square, and drift": line(y, x, x**2, t),
        "year": line(y, x, *tone(t, 1)),
        "drift, and year": line(y, x, t, *tone(t, 1)),
        "step": terms(y, lambda p: [x, after(p[0])], [3.5]),
        "drift, and step": terms(y, lambda p: [x, t, after(p[0])], [2.9]),
    }
