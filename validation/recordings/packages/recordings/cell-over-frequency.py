"""Capacitance of a solar cell over the decades of the frequency, 200 Hz to 2 MHz, a run each 10 K from 123 K to 303 K. What is trapped follows slow waves, and quicker ones the warmer it is."""

import numpy as np
from models.drivers import of_drivers
from models.fitting import line, scaled, terms
from readers.grapa import capacitances

HAND_BUILT = "all cubes"


def rows(*contents):
    return capacitances(*contents)


def models(c):
    y, x, cell = 1000 * c["capacitance_nf"], c["decades"], c["cell_k"]  # answers are in pF
    u, v = scaled(x), scaled(cell)
    squares = [u**2, v, u * v, v**2]
    step = lambda p: np.tanh((x - p[0] - p[1] * v) / (abs(p[2]) + 0.01))
    return y, {
        **of_drivers(y, x, cell=cell),
        "all cubes": line(y, x, *squares, u**3, u**2 * v, u * v**2, v**3),
        "step": terms(y, lambda p: [x, step((p[0], 0, p[1]))], [5.5, 0.5]),
        "step that goes with warmth": terms(y, lambda p: [x, v, step(p)], [5.5, 0.5, 0.5]),
        "step that goes with warmth, and all squares": terms(y, lambda p: [x, *squares, step(p)], [5.5, 0.5, 0.5]),
    }
