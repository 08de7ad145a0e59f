"""Transmission past a superconducting resonator at 0.75 K over that at 0.67 K, over frequency, a row counts as a second. The resonance has moved."""

from itertools import islice

from models.bends import usual_and_bends
from models.fitting import terms
from models.lags import moved
from readers.scraps import traces

HAND_BUILT = "shift"


def rows(content):
    (*_, cold), _, (*_, warm) = islice(traces(content, 1, (-10,)), 20, 23)
    return {"time_s": [float(k) for k in range(len(cold))], "cold_permille": cold * 1000, "warm_permille": warm * 1000}


def models(c):
    y, x, t = c["warm_permille"], c["cold_permille"], c["time_s"]
    both = lambda p: moved(x, t, p[0] * 60)
    return y, {
        **usual_and_bends(y, x, t, 60),
        "shift, and square": terms(y, lambda p: [both(p), both(p) ** 2], [0.5]),
        "shift, and drift": terms(y, lambda p: [both(p), t], [0.5]),
    }
