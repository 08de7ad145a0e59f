"""Mass that a vibrating-sample magnetometer tells of what it shakes, while the field goes round, 24 min. It comes to rest."""

import numpy as np
from formats.clock import since_first
from formats.multivu import multivu
from models.fitting import line, terms

HAND_BUILT = "exponential, and drift"


def rows(content):
    frame = multivu(content)
    return {"time_s": since_first(frame["Time Stamp (sec)"]), "field_koe": frame["Magnetic Field (Oe)"] / 1000, "mass_g": frame["Mass (grams)"]}


def models(c):
    y, t, field = c["mass_g"], c["time_s"], c["field_koe"]
    return y, {
        "constant": line(y),
        "drift": line(y, t),
        "field": line(y, field),
        "exponential": terms(y, lambda p: [np.exp(-t / (abs(p[0]) * 100))], [2.0]),
        HAND_BUILT: terms(y, lambda p: [np.exp(-t / (abs(p[0]) * 100)), t], [2.0]),
    }
