"""Spectrum of two radicals together over that of one of them, at the same steps of a field. The other one adds to it, and the field was not quite the same."""

from models.drivers import of_drivers
from models.fitting import line, terms
from models.lags import lag, moved
from readers.pyepri import radicals

HAND_BUILT = "other, and shift of both"


def rows(*contents):
    mixture, one, other = radicals(*contents, every=2)
    return {"time_s": range(len(one)), "one": one, "other": other, "mixture": mixture}


def models(c):
    y, x, other, t = c["mixture"], c["one"], c["other"], c["time_s"]
    at = lambda u, by: moved(u, t, by)
    return y, {
        **of_drivers(y, x, other=other),
        "shift": terms(y, lambda p: [at(x, p[0])], [0.3]),
        "other, and shift of the one": terms(y, lambda p: [at(x, p[0]), other], [0.3]),
        "other, and shift of both": terms(y, lambda p: [at(x, p[0]), at(other, p[0])], [0.3]),
        "other, and shift of each": terms(y, lambda p: [at(x, p[0]), at(other, p[1])], [0.3, 0.3]),
        "other, and lag": terms(y, lambda p: [lag(x, t, abs(p[0])), lag(other, t, abs(p[0]))], [0.5]),
        "other, and drift": line(y, x, other, t),
        "other, shift of both, and square": terms(y, lambda p: [at(x, p[0]), at(x, p[0]) ** 2, at(other, p[0])], [0.3]),
    }
