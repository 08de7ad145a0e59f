"""How far east somebody is who goes to and fro, by one watch over that by another on the same body, every third second. Each has a clock of its own."""

from models.fitting import line, scaled, terms
from models.lags import lag, moved, usual_and_shifts
from readers.tracklib import two_tracks, watch

HAND_BUILT = "shift ahead, and drift"


def rows(first, second):
    return two_tracks(watch(first), watch(second), "east", 3, late=7200)


def models(c):
    y, x, t = c["second_m"], c["first_m"], c["time_s"]
    v, at = scaled(t), lambda p: moved(x, t, p * 10)
    return y, {
        **usual_and_shifts(y, x, t, 10),
        "shift ahead, and drift": terms(y, lambda p: [at(p[0]), v], [-0.1]),
        "shift ahead, drift, and its square": terms(y, lambda p: [at(p[0]), v, v**2], [-0.1]),
        "shift ahead, drift, and slope that drifts": terms(y, lambda p: [at(p[0]), v, v * at(p[0])], [-0.1]),
        "drift, and its square": line(y, x, v, v**2),
        "drift, and lag": terms(y, lambda p: [lag(x, t, abs(p[0]) * 10), v], [0.1]),
    }
