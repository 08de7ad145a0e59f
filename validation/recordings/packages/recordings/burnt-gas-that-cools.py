"""Pressure of burnt gas that cools behind a piston, over that of gas that was compressed as far and did not burn. What is hotter cools faster."""

from models.fitting import line, scaled
from models.lags import behind, usual_and_shifts
from readers.uconnrcmpy import slow_shots

HAND_BUILT = "cube"


def rows(*contents):
    return slow_shots(*contents, begin=0.5, rows=500)


def models(c):
    y, x, t = c["second_v"], c["first_v"], c["time_s"]
    u, w = scaled(x), scaled(t)
    return y, {
        **usual_and_shifts(y, x, t, 0.1),
        "cube": line(y, x, u**2, u**3),
        "fourth power": line(y, x, u**2, u**3, u**4),
        "drift, and its square": line(y, x, w, w**2),
        "drift, and slope that drifts": line(y, x, w, u * w),
        "square, and drift": line(y, x, u**2, w),
        "cube, and drift": line(y, x, u**2, u**3, w),
        **behind(y, x, t, 0.1),
    }
