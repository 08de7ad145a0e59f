"""How fast a heart beats over the oxygen that is taken up, as the work grows until it is too much. The heart is behind the breath."""

import numpy as np
from fitting import lag, line, moved, scaled, terms
from needles import exercise
from pickups import clocks

HAND_BUILT = "lag, and cube"


def rows(content):
    return exercise(content, 3, oxygen_ml_min="VO2_I", heart_per_min="HR_I")


def models(c):
    y, x, t = c["heart_per_min"], c["oxygen_ml_min"], c["time_s"]
    u, w, late = scaled(x), scaled(t), lambda p: lag(x, t, abs(p) * 20)
    bend = lambda p: (late(p[0]), scaled(late(p[0])) ** 2, scaled(late(p[0])) ** 3)
    return y, {
        **clocks(y, x, t, 20),
        "cube": line(y, x, u**2, u**3),
        "drift, and its square": line(y, x, w, w**2),
        "drift, and slope that drifts": line(y, x, w, u * w),
        "square, and drift": line(y, x, u**2, w),
        "cube, and drift": line(y, x, u**2, u**3, w),
        "logarithm": line(y, x, np.log(t + 10)),
        "lag, and square": terms(y, lambda p: bend(p)[:2], [1.0]),
        "lag, and cube": terms(y, bend, [1.0]),
        "lag, and drift": terms(y, lambda p: [late(p[0]), w], [1.0]),
        "lag, cube, and drift": terms(y, lambda p: [*bend(p), w], [1.0]),
        "line, and lag": terms(y, lambda p: [x, late(p[0])], [1.0]),
        "two lags": terms(y, lambda p: [late(p[0]), late(p[1])], [1.0, 4.0]),
        "lag of a lag": terms(y, lambda p: [lag(late(p[0]), t, abs(p[1]) * 20)], [1.0, 0.5]),
        "lag, and shift": terms(y, lambda p: [moved(late(p[0]), t, p[1] * 20)], [1.0, 0.5]),
        "drift alone": line(y, w),
    }
