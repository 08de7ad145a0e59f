"""How bright a sensor sees a screen over the grey that is shown, 300 of them as they came. A screen is dark for long as its grey grows, and what the sensor tells falls as it goes on."""

import numpy as np
from models.fitting import line, scaled, terms
from readers.cdt import pair_columns

HAND_BUILT = "cube, and drift"


def rows(content):
    return pair_columns(content, step=1, grey=("pair96", "A"), brightness=("pair96", "B"))


def models(c):
    y, x, t = c["brightness"], c["grey"], c["time_s"]
    u, w, half = scaled(x), scaled(t), t > t.max() / 2
    bend = u, u**2, u**3
    return y, {
        "line": line(y, x),
        "square": line(y, x, u**2),
        "cube": line(y, *bend),
        "fourth power": line(y, *bend, u**4),
        "power": terms(y, lambda p: [(x / 255) ** abs(p[0])], [2.2]),
        "drift": line(y, x, w),
        "square, and drift": line(y, x, u**2, w),
        "cube, and drift": line(y, *bend, w),
        "cube, drift, and its square": line(y, *bend, w, w**2),
        "cube, drift, and slope that drifts": line(y, *bend, w, u * w),
        "cube, and slope that drifts": line(y, *bend, u * w),
        "cube, and what it gives times a drift": line(y, *bend, w, *(part * w for part in bend)),
        "cube, and logarithm": line(y, *bend, np.log(t + 10)),
        "cube, and step in the middle": line(y, *bend, half),
        "power, and drift": terms(y, lambda p: [(x / 255) ** abs(p[0]), w], [2.2]),
    }
