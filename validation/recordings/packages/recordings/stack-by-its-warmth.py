"""Volts of a cell that splits water over its current, at six warmths one after another."""

import numpy as np
from formats.text import csv
from models.drivers import gains, of_drivers
from models.fitting import line, scaled
from readers.aec_modelling import cell_columns

HAND_BUILT = "warmth, and logarithm"


def rows(content):
    return cell_columns(csv(content).sort_values(["T", "j"], kind="stable"))


def models(c):
    y, x, warmth = c["volts"], c["current_ma_cm2"], c["warmth_degc"]
    u, v, bend = scaled(x), scaled(warmth), np.log(x)
    return y, {
        **of_drivers(y, x, warmth=warmth),
        **gains(y, x, warmth=warmth),
        "logarithm": line(y, x, bend),
        "warmth, and logarithm": line(y, x, v, bend),
        "warmth, logarithm, and square": line(y, x, v, bend, u**2),
        "warmth, logarithm, and slope by warmth": line(y, x, v, bend, v * x),
        "warmth bent, and logarithm": line(y, x, v, v**2, bend),
        "warmth bent, logarithm, and slope by warmth": line(y, x, v, v**2, bend, v * x),
    }
