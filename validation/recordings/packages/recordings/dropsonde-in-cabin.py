"""Temperature by a dropsonde that stays in the cabin of its aircraft, 40 minutes, every second row. It comes to rest."""

import numpy as np
from models.fitting import line, terms
from readers.pydropsonde import cabin

HAND_BUILT = "drift that fades"


def rows(content):
    frame = cabin(content)
    return {"time_s": frame.time_s, "sonde_c": frame.degc}


def models(c):
    y, t = c["sonde_c"], c["time_s"]
    fading = lambda p: np.exp(-t / (abs(p) * 600))
    return y, {
        "constant": line(y),
        "drift": line(y, t),
        "drift, bent": line(y, t, t**2),
        HAND_BUILT: terms(y, lambda p: [fading(p[0])], [1.0]),
        "drift that fades, and one that does not": terms(y, lambda p: [fading(p[0]), t], [1.0]),
    }
