"""Volts of a cell that splits water over its current, four hours of an afternoon. It gets warm, and after a pause it is another."""

import numpy as np
from models.drivers import of_drivers
from models.fitting import line, scaled
from models.jumps import switched_at
from readers.aec_modelling import stack

HAND_BUILT = "step, logarithm, and warmth"
PAUSE = 5000


def rows(content):
    return stack(content)


def models(c):
    y, x, t, warmth = c["volts"], c["current_ma_cm2"], c["time_s"], c["warmth_degc"]
    u, v, w, after, bend = scaled(x), scaled(warmth), scaled(t), (t > PAUSE) * 1.0, np.log(x)
    return y, {
        **of_drivers(y, x, warmth=warmth),
        "logarithm": line(y, x, bend),
        "drift": line(y, x, w),
        "logarithm, warmth, and drift": line(y, x, bend, v, w),
        **switched_at(y, x, t, PAUSE),
        "step, and logarithm": line(y, x, after, bend),
        "step, and warmth": line(y, x, after, v),
        "step, square, and warmth": line(y, x, after, u**2, v),
        "step, logarithm, and warmth": line(y, x, after, bend, v),
        "step, logarithm, and slope by warmth": line(y, x, after, bend, v, v * x),
        "step, logarithm, and warmth of it": line(y, x, after, bend, v * bend),
        "step, logarithm, warmth, and its square": line(y, x, after, bend, v, v**2),
        "step, logarithm, warmth, and drift": line(y, x, after, bend, v, w),
        "step, slope from then on, logarithm, and warmth": line(y, x, after, after * x, bend, v),
    }
