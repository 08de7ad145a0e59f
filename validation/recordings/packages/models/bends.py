"""Curves instead of a straight line: powers, corners, what levels off."""

import numpy as np
from models.fitting import line, scaled, terms
from models.lags import lag, moved, usual


def bends(y, x):
    """Models of a curve `y` over `x` that comes to another slope."""
    scale = float(np.ptp(x)) / 20
    soft = lambda p: np.logaddexp(0, (x - p[0]) / abs(p[1]))
    return {
        "line": line(y, x),
        "square": line(y, x, x**2),
        "cubic": line(y, x, x**2, x**3),
        "soft bend": terms(y, lambda p: [x, soft(p)], [float(np.quantile(x, 0.25)), scale]),
        "saturation": terms(y, lambda p: [x, np.tanh((x - p[0]) / abs(p[1]))], [float(np.quantile(x, 0.25)), 2 * scale]),
    }


def usual_and_bends(y, x, t, unit):
    """What is tried where a law is bent: beside the usual models a cube, alone and with a drift, with a shift, with a lag, and more powers."""
    u = scaled(x)
    cube, fifth = ([u**k for k in range(1, n)] for n in (4, 6))
    return {
        **usual(y, x, t, unit),
        "cube": line(y, *cube),
        "cube, and drift": line(y, *cube, t),
        "cube that is shifted": terms(y, lambda p: [moved(term, t, p[0] * unit) for term in cube], [0.3]),
        "cube, and lag": terms(y, lambda p: [*cube, lag(u, t, abs(p[0]) * unit)], [1.0]),
        "fifth power": line(y, *fifth),
        "fifth power that is shifted": terms(y, lambda p: [moved(term, t, p[0] * unit) for term in fifth], [0.3]),
        "fifth power, and lag": terms(y, lambda p: [*fifth, lag(u, t, abs(p[0]) * unit)], [1.0]),
        "ninth power": line(y, *(u**k for k in range(1, 10))),
    }


def bends_with(y, x, **others):
    """A square and a cube, alone and with each of some other terms, after the line."""
    u = scaled(x)
    models = {"line": line(y, x), "square": line(y, x, u**2), "cube": line(y, x, u**2, u**3)}
    for name, term in others.items():
        models |= {name: line(y, x, term), f"{name}, and slope by it": line(y, x, term, x * term), f"square, and {name}": line(y, x, u**2, term)}
    return models


def corner(y, x, at):
    """A line that turns into another, over a width that is fitted."""
    return terms(y, lambda p: [x, abs(p[1]) * np.logaddexp(0, (x - p[0]) / abs(p[1]))], [at, 0.5])


def levels_off(y, x, width):
    """Models of what levels off: a root, a power, a hyperbola, a corner and what goes on behind it."""
    return {
        "root": line(y, np.sqrt(x)),
        "power": terms(y, lambda p: [x ** abs(p[0])], [0.8]),
        "hyperbola": terms(y, lambda p: [x / (x + abs(p[0]) * width)], [1.0]),
        "corner": terms(y, lambda p: [x, np.maximum(x - p[0] * width, 0)], [1.0]),
        "fading": terms(y, lambda p: [x, np.exp(-x / (abs(p[0]) * width + 1e-9 * x.max()))], [0.3]),
    }
