"""Least squares for models built by hand: straight in some terms, or curved by a few numbers.

A model is a function of the rows that may be seen, as a mask; it gives a prediction of every row.
"""

import numpy as np
from scipy.optimize import least_squares
from scipy.signal import lfilter


def scaled(x):
    """Values less their mean, over their scatter."""
    return (x - x.mean()) / x.std()


def line(y, *terms):
    """A constant and terms, each with a coefficient."""
    return through_zero(y, np.ones(len(y)), *terms)


def through_zero(y, *terms):
    """Terms, each with a coefficient, and no constant."""
    matrix = np.column_stack([np.asarray(term, float) for term in terms])
    matrix = matrix / (np.abs(matrix).max(axis=0) + 1e-300)
    return lambda seen: matrix @ np.linalg.lstsq(matrix[seen], y[seen], rcond=None)[0]


def terms(y, basis, start, combine=line):
    """Terms that hold some numbers: `basis(p)` gives them. Coefficients are solved for inside of the search for `p`."""
    return lambda seen: searched(y, lambda p: combine(y, *basis(p))(seen), start, seen)


def curve(y, predict, start):
    """A prediction by some numbers, `predict(p)`."""
    return lambda seen: searched(y, predict, start, seen)


def searched(y, predict, start, seen):
    """The prediction by the numbers that fit best."""
    best = least_squares(lambda p: (predict(p) - y)[seen], start, x_scale="jac", max_nfev=300)
    return predict(best.x)


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


def angle(degrees, centre, width):
    """A bell over an angle, 1 at its centre; centre and width in rad."""
    away = (np.radians(degrees) - centre + np.pi) % (2 * np.pi) - np.pi
    return np.exp(-0.5 * (away / width) ** 2)


def tone(t, period):
    """Sine and cosine of a period."""
    return [np.sin(2 * np.pi * t / period), np.cos(2 * np.pi * t / period)]
