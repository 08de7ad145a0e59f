"""What goes with the time of day or another period."""

import numpy as np
from durations import DAY
from models.fitting import line, scaled, terms
from models.lags import moved, usual


def tone(t, period):
    """Sine and cosine of a period."""
    return [np.sin(2 * np.pi * t / period), np.cos(2 * np.pi * t / period)]


def usual_and_day(y, x, t):
    """Models of a thermometer beside another one that goes through the day ahead of it or behind it."""
    day = [*tone(t, DAY), *tone(t, DAY / 2)]
    at = lambda p: moved(x, t, p[0] * 3600)
    return {
        **usual(y, x, t, 3600),
        "shift ahead": terms(y, lambda p: [at(p)], [-0.5]),
        "day": line(y, x, *day),
        "day, and square": line(y, x, x**2, *day),
        "day, and drift": line(y, x, t, *day),
        "shift, and square": terms(y, lambda p: [at(p), at(p) ** 2], [-0.5]),
        "shift, and day": terms(y, lambda p: [at(p), *day], [-0.5]),
        "shift, day, and slope by it": terms(y, lambda p: [at(p), *day, *(at(p) * k for k in day[:2])], [-0.5]),
    }


def waves_of_day(y, x, t):
    """Models of what goes with the time of day, three waves, beside a bend, a drift and slopes."""
    u, w, day = scaled(x), scaled(t), [part for wave in (1, 2, 3) for part in tone(t, DAY / wave)]
    return {
        "one wave a day": line(y, x, *day[:2]),
        "two waves a day": line(y, x, *day[:4]),
        "day": line(y, x, *day),
        "day, and square": line(y, x, u**2, *day),
        "day, and cube": line(y, x, u**2, u**3, *day),
        "day, and drift": line(y, x, w, *day),
        "day, square, and drift": line(y, x, u**2, w, *day),
        "day, and slope by it": line(y, x, *day, *(u * part for part in day)),
        "day, and slope that drifts": line(y, x, w, u * w, *day),
        "day alone": line(y, *day),
    }
