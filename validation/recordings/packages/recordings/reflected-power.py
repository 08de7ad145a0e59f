"""Power that comes back from a radio-frequency line, by a second meter, over the power that is sent in, six sweeps up and down at a standing wave of 4.

A constant share, read a part of a row earlier. A row counts as a second; the file has no clock.
"""

import numpy as np
from formats.text import csv
from models.fitting import line, terms

HAND_BUILT = "shift, and square"


def rows(content):
    d = csv(content, sep="\t").dropna(subset=["NI9205_Power1", "NI9205_Power2"])
    return {"row": np.arange(len(d)) * 1.0, "sent_w": d.NI9205_Power1, "reflected_w": d.NI9205_Power2}


def models(c):
    y, x, t = c["reflected_w"], c["sent_w"], c["row"]

    def shifted(p):
        return [np.interp(t - p[0], t, x)]

    return y, {
        "line": line(y, x),
        "square": line(y, x, x**2),
        "drift": line(y, x, t),
        "shift": terms(y, shifted, [-0.3]),
        HAND_BUILT: terms(y, lambda p: [*shifted(p), x**2], [-0.3]),
        "rate": line(y, x, np.gradient(x)),
    }
