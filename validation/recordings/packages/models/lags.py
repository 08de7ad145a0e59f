"""What comes later than its cause: by a shift of its clock, by a lag, by play."""

import numpy as np
from models.fitting import line, terms
from scipy.signal import lfilter


def lag(u, t, tau):
    """First-order lag of `u`, exact for an input that keeps the mean of two rows between them."""
    keep = np.exp(-np.diff(t) / max(tau, 1e-9))
    middle = (u[1:] + u[:-1]) / 2
    out = np.empty(len(u))
    out[0] = u[0]
    if np.allclose(np.diff(t), t[1] - t[0], rtol=1e-3):
        out[1:] = lfilter([1 - keep[0]], [1, -keep[0]], middle, zi=[keep[0] * u[0]])[0]
        return out
    for i, (share, value) in enumerate(zip(keep, middle), 1):
        out[i] = share * out[i - 1] + (1 - share) * value
    return out


def play(x, width):
    """What follows with a play of so much to each side."""
    out, at = np.empty(len(x)), x[0]
    for k, value in enumerate(x):
        at = min(max(at, value - width), value + width)
        out[k] = at
    return out


def moved(x, t, by):
    """Values a while later, straight between rows."""
    return np.interp(t - by, t, x)


def usual(y, x, t, unit=60):
    """What is tried first beside a straight line: a bend, a drift, a clock that is off, a lag; the last two begin at half a unit, which is in s."""
    return {
        "line": line(y, x),
        "square": line(y, x, x**2),
        "drift": line(y, x, t),
        "shift": terms(y, lambda p: [moved(x, t, p[0] * unit)], [0.5]),
        "lag": terms(y, lambda p: [lag(x, t, abs(p[0]) * unit)], [0.5]),
    }


def late_models(y, x, t, unit):
    """What is tried where heat comes late: beside the usual models a lag with a drift, two lags, and a lag of a lag; lags begin at half a unit, in s."""
    late = lambda p: lag(x, t, abs(p) * unit)
    return {
        **usual(y, x, t, unit),
        "line and lag": terms(y, lambda p: [x, late(p[0])], [0.5]),
        "lag, and drift": terms(y, lambda p: [late(p[0]), t], [0.5]),
        "lag, drift, and its square": terms(y, lambda p: [late(p[0]), t, t**2], [0.5]),
        "two lags": terms(y, lambda p: [lag(late(p[0]), t, abs(p[1]) * unit)], [0.5, 0.2]),
    }


def usual_and_lags(y, x, t, unit):
    """What is tried where one thing is behind another: beside the usual models a lag with more, and a lag of a lag; lags begin at half a unit, in s."""
    late = lambda p: lag(x, t, abs(p) * unit)
    return {
        **usual(y, x, t, unit),
        "line and lag": terms(y, lambda p: [x, late(p[0])], [0.5]),
        "lag, and drift": terms(y, lambda p: [late(p[0]), t], [0.5]),
        "lag, and square": terms(y, lambda p: [late(p[0]), late(p[0]) ** 2], [0.5]),
        "lag, and shift": terms(y, lambda p: [moved(late(p[0]), t, p[1] * unit)], [0.5, 0.1]),
        "two lags": terms(y, lambda p: [lag(late(p[0]), t, abs(p[1]) * unit)], [3.0, 0.3]),
    }


def late_shifts(y, x, t, unit, late, apart=0.0):
    """What is tried where one thing comes after another by a time that is another at the end; search begins at so many units, and at so many more from one end to the other."""
    shifted = lambda p: moved(x, t, p[0] * unit)
    then = lambda p: np.interp(t - (p[0] + p[1] * (t / t[-1] - 0.5)) * unit, t, x)
    return {
        **usual(y, x, t, unit),
        "shift from there": terms(y, lambda p: [shifted(p)], [late]),
        "shift, and square": terms(y, lambda p: [shifted(p), shifted(p) ** 2], [late]),
        "shift, and drift": terms(y, lambda p: [shifted(p), t], [late]),
        "shift, and lag": terms(y, lambda p: [lag(shifted(p), t, abs(p[1]) * unit)], [late, 0.3]),
        "shift that changes": terms(y, lambda p: [then(p)], [late, apart]),
        "shift that changes, and square": terms(y, lambda p: [then(p), then(p) ** 2], [late, apart]),
        "shift that changes, and slope that drifts": terms(y, lambda p: [then(p), t * then(p)], [late, apart]),
    }


def in_runs(run, t, what):
    """What is made of each run by itself: of its rows, and of its time from 0 on."""
    out = np.empty(len(t))
    for number in np.unique(run):
        rows = run == number
        out[rows] = what(rows, t[rows] - t[rows][0])
    return out


def usual_and_shifts(y, x, t, unit, **others):
    """What is tried first, and a shift beside a bend, a drift and other terms, either way."""
    at = lambda p: moved(x, t, p[0] * unit)
    models = {
        **usual(y, x, t, unit),
        "shift ahead": terms(y, lambda p: [at(p)], [-0.5]),
        "shift, and square": terms(y, lambda p: [at(p), at(p) ** 2], [-0.5]),
        "shift, and drift": terms(y, lambda p: [at(p), t], [-0.5]),
    }
    for name, term in others.items():
        models |= {name: line(y, x, term), f"shift, and {name}": terms(y, lambda p, term=term: [at(p), term], [-0.5])}
    return models


def behind(y, x, t, unit):
    """Models of what comes later than its cause, by a lag that begins at one unit in s: alone, and beside a bend, a drift, a shift and another lag."""
    late = lambda p: lag(x, t, abs(p) * unit)
    return {
        "lag, and square": terms(y, lambda p: [late(p[0]), late(p[0]) ** 2], [1.0]),
        "lag, and drift": terms(y, lambda p: [late(p[0]), t], [1.0]),
        "line, and lag": terms(y, lambda p: [x, late(p[0])], [1.0]),
        "lag of a lag": terms(y, lambda p: [lag(late(p[0]), t, abs(p[1]) * unit)], [0.5, 0.5]),
        "two lags": terms(y, lambda p: [late(p[0]), late(p[1])], [0.5, 2.0]),
    }
