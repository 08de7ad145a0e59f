"""Warmth of what lies in a dryer over that of its jacket, while it is cooled from 84 degC: 41 batches, from six rows before on."""

import numpy as np
from models.fitting import line, terms
from models.lags import in_runs, lag, moved
from readers.process_improve import cooled_batches

HAND_BUILT = "lag, and line"


def rows(content):
    return cooled_batches(content, 31, 71, before=6)


def models(c):
    y, x, t, run = c["product_degc"], c["jacket_degc"], c["time_s"], c["run"]
    late = lambda *taus: in_runs(run, t, lambda rows, s: chained(x[rows], s, taus))
    begun = in_runs(run, t, lambda rows, s: s)
    return y, {
        "line": line(y, x),
        "square": line(y, x, x**2),
        "time": line(y, x, begun),
        "what fades": terms(y, lambda p: [x, np.exp(-begun / (abs(p[0]) * 60 + 60))], [20.0]),
        "shift": terms(y, lambda p: [in_runs(run, t, lambda rows, s: moved(x[rows], s, p[0] * 60))], [5.0]),
        "lag": terms(y, lambda p: [late(p[0])], [20.0]),
        "lag, and line": terms(y, lambda p: [x, late(p[0])], [20.0]),
        "lag, and square": terms(y, lambda p: [late(p[0]), late(p[0]) ** 2], [20.0]),
        "lag, and time": terms(y, lambda p: [late(p[0]), begun], [20.0]),
        "lag, and batch": terms(y, lambda p: [late(p[0]), run], [20.0]),
        "lag of a lag": terms(y, lambda p: [late(p[0], p[1])], [20.0, 2.0]),
        "lag of a lag, and square": terms(y, lambda p: [late(p[0], p[1]), late(p[0], p[1]) ** 2], [20.0, 2.0]),
    }


def chained(x, t, minutes):
    """One lag behind the other, time constants in minutes."""
    for tau in minutes:
        x = lag(x, t, abs(tau) * 60 + 1)
    return x
