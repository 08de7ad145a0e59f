"""Power of a solar cell that is kept at 83 degC and in light, each half an hour of eight days; hours with less light are left out."""

import numpy as np
from durations import DAY
from models.cycles import tone
from models.fitting import line, scaled, terms
from readers.grapa import cell_kept_hot

HAND_BUILT = "step, and drift"
AT = 3.55 * DAY


def rows(content):
    return cell_kept_hot(content, least=5.7)


def models(c):
    y, t = c["power_mw_cm2"], c["time_s"]
    v, none = scaled(t), np.zeros(len(t))
    return y, {
        "mean": line(y, none),
        "drift": line(y, v),
        "drift, and its square": line(y, v, v**2),
        "logarithm": line(y, np.log1p(t / 1800)),
        "what fades": terms(y, lambda p: [np.exp(-t / (abs(p[0]) + 0.01) / DAY)], [2.0]),
        "drift, and what fades": terms(y, lambda p: [v, np.exp(-t / (abs(p[0]) + 0.01) / DAY)], [0.5]),
        "step": line(y, t > AT),
        "step, and drift": line(y, v, t > AT),
        "step, and drift that changes": line(y, v, t > AT, v * (t > AT)),
        "drift, and day": line(y, v, *tone(t, DAY)),
    }
