"""Heat that a sample takes up as it melts, warmed by 20 K/min, over what it took up at the same warmth when warmed by 2.5 K/min. Heat takes time to come to it."""

from models.fitting import terms
from models.lags import behind, lag, moved, usual_and_shifts
from readers.fpex0 import melting

HAND_BUILT = "lag"


def rows(fast, slow):
    return melting(fast, slow, 100, 156.5)


def models(c):
    y, x, t = c["fast_j_gk"], c["slow_j_gk"], c["time_s"]
    late = lambda p: lag(x, t, abs(p) * 20)
    return y, {**usual_and_shifts(y, x, t, 20), **behind(y, x, t, 20), "shift, and lag": terms(y, lambda p: [moved(late(p[1]), t, p[0] * 20)], [0.3, 0.5])}
