"""What drifts with the time or comes to rest."""

import numpy as np
from durations import DAY
from models.cycles import tone
from models.fitting import line, scaled, terms
from models.jumps import changed
from models.lags import usual, usual_and_shifts


def fades(t, share):
    """One at the first row, and less by a factor of e after a share of the whole time."""
    return np.exp(-t / ((abs(share) + 1e-3) * t[-1]))


def comes_to_rest(y, t):
    """Models of something `y` that comes to rest."""
    return {
        "constant": line(y),
        "drift": line(y, t),
        "square": line(y, t, t**2),
        "logarithm": line(y, np.log(t + 60)),
        "exponential": terms(y, lambda p: [fades(t, p[0])], [0.3]),
        "exponential, and drift": terms(y, lambda p: [fades(t, p[0]), t], [0.3]),
    }


def courses(y, t):
    """Models of something `y` that nothing but the clock tells: drifts, a drift to a rest, and a step."""
    w = scaled(t)
    return {
        "constant": line(y),
        "drift": line(y, w),
        "drift, and its square": line(y, w, w**2),
        "drift, its square and cube": line(y, w, w**2, w**3),
        "drift to a rest": terms(y, lambda p: [fades(t, p[0])], [0.3]),
        "step": changed(y, t, [], 1.0),
        "drift, and step": changed(y, t, [w], 1.0),
    }


def usual_and_drifts(y, x, t):
    """What is tried where one gas in air is told over another: a bend, a clock, and slopes that go with the time; last with the day."""
    u, v = scaled(x), scaled(t)
    day, step = tone(t, DAY), (t > t[-1] / 2) * 1.0
    return {
        **usual(y, x, t, 3600),
        "step": line(y, x, step),
        "slope and step": line(y, x, step, x * step),
        "slope that drifts": line(y, x, v, u * v),
        "slope that drifts alone": line(y, x, u * v),
        "drift, and its square": line(y, x, v, v**2),
        "slope that drifts, square of the time": line(y, x, v, u * v, v**2, u * v**2),
        "slope that drifts, and square": line(y, x, u**2, v, u * v),
        "day": line(y, x, *day),
        "slope that drifts, and day": line(y, x, v, u * v, *day),
    }


def usual_shifts_and_drifts(y, x, t, unit):
    """What is tried beside a clock: drifts that bend, by the logarithm and to a rest, slopes that drift, a square and a day."""
    u, w = scaled(x), scaled(t)
    return {
        **usual_and_shifts(y, x, t, unit),
        "cube": line(y, x, u**2, u**3),
        "drift, and its square": line(y, x, w, w**2),
        "drift, and square": line(y, x, w, u**2),
        "drift by the logarithm": line(y, x, np.log(t + unit)),
        "drift to a rest": terms(y, lambda p: [x, np.exp(-t / ((1 + abs(p[0])) * unit))], [100.0]),
        "slope that drifts": line(y, x, w, u * w),
    }
