"""How far four radios are from a robot, by how long their waves take, over how far they are by where satellites say that it is."""

import numpy as np
from models.bends import bends_with
from models.fitting import line
from models.lags import usual_and_shifts
from readers.gtsam import radio_ranges

HAND_BUILT = "line"


def rows(content):
    return radio_ranges(content)


def models(c):
    y, x, t = c["radio_m"], c["apart_m"], c["time_s"]
    return y, {
        "as it is": lambda seen: x,
        "zero": lambda seen: x + np.mean((y - x)[seen]),
        **bends_with(y, x, drift=t),
        **{name: model for name, model in usual_and_shifts(y, x, t, 1).items() if name in ("shift", "lag")},
        "drift, and its square": line(y, x, t, t**2),
        "logarithm": line(y, x, np.log(x)),
    }
