"""Load of a specimen that is pulled over the way of the crosshead. For two millimetres it slips in its grips, then they hold it."""

import numpy as np
from models.bends import corner, usual_and_bends
from models.fitting import line, terms
from models.jumps import soft_step
from readers.pyziagn import pulled_specimen

HAND_BUILT = "corner"


def rows(content):
    read = pulled_specimen(content)
    return {"time_s": read["time_s"], "crosshead_mm": read["way_mm"], "load_kn": read["load_kn"]}


def models(c):
    y, x, t = c["load_kn"], c["crosshead_mm"], c["time_s"]
    taken = lambda at: 0.1 * np.logaddexp(0, (x - at) / 0.1)
    return y, {
        **usual_and_bends(y, x, t, 5),
        "square, and drift": line(y, x, x**2, t),
        "corner": corner(y, x, 2.3),
        "two corners": terms(y, lambda p: [x, taken(p[0]), taken(p[1])], [2.3, 1.6]),
        "corner, and slip": terms(y, lambda p: [x, taken(p[0]), soft_step(x, p[1], 0.005)], [2.3, 1.55]),
        "corner, slip, and what begins": terms(y, lambda p: [x, taken(p[0]), soft_step(x, p[1], 0.005), np.exp(-x / (abs(p[2]) * 0.05))], [2.3, 1.55, 1.0]),
    }
