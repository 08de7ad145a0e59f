"""Density of red wines over their alcohol, 1599 of them. What else is dissolved makes them dense: acid and sugar."""

import numpy as np
from formats.text import columns
from models.drivers import of_drivers
from models.fitting import line, scaled

HAND_BUILT = "both, bent"


def rows(content):
    told = columns(content, acid_g_l="fixed_acidity", alcohol_percent="alcohol", sugar_g_l="residual_sugar", density="density")
    return {**told, "density": np.round(told["density"] * 1000, 6)}


def models(c):
    y, x, acid, sugar = c["density"], c["alcohol_percent"], c["acid_g_l"], c["sugar_g_l"]
    u, v, w, at = scaled(x), scaled(acid), scaled(sugar), scaled(np.arange(len(x)))
    return y, {
        **of_drivers(y, x, acid=acid, sugar=sugar),
        "both": line(y, x, v, w),
        "both, and square": line(y, x, u**2, v, w),
        "slopes by both": line(y, x, v, w, u * v, u * w),
        "slopes by both alone": line(y, x, u * v, u * w),
        "both, bent": line(y, x, v, w, v**2, w**2),
        "drift": line(y, x, at),
        "both, and drift": line(y, x, v, w, at),
    }
