"""Ground over a coal mine by one geophone over that by another, 87 m away: vertical, 250 times a second, 28 s with some tremors."""

from models.fitting import line, terms
from models.lags import lag, moved, usual_and_shifts
from readers.opsdata_coal_node import geophones

HAND_BUILT = "each of 33 rows"


def rows(content):
    return geophones(content, 7000, 250, nearer="5", farther="12")


def models(c):
    y, x, t = c["farther"], c["nearer"], c["time_s"]
    at = lambda p: moved(x, t, p * 0.02)
    return y, {
        **usual_and_shifts(y, x, t, 0.02),
        "shift later": terms(y, lambda p: [at(p[0])], [1.2]),
        "shift later, and square": terms(y, lambda p: [at(p[0]), at(p[0]) ** 2], [1.2]),
        "shift later, and lag": terms(y, lambda p: [lag(at(p[0]), t, abs(p[1]) * 0.02)], [1.0, 0.3]),
        "two shifts": terms(y, lambda p: [at(p[0]), at(p[1])], [1.2, 0.5]),
        "each of 33 rows": line(y, *[moved(x, t, k / 250) for k in range(-16, 17)]),
    }
