"""Light of a neon lamp on 1801 pixels of a spectrometer while it gathers for 100 ms, over that while it gathers for 5 ms. A converter of sixteen bits tells no more than 65535."""

import numpy as np
from models.bends import bends_with
from models.fitting import curve, line, terms
from readers.ramanchada2 import spectrum

HAND_BUILT = "line that ends"
END = 65535


def rows(short, long):
    return {"short_counts": spectrum(short, "Raw data #1")[1], "long_counts": spectrum(long, "Raw data #1")[1]}


def models(c):
    y, x = c["long_counts"], c["short_counts"] / 1000
    return y, {
        **bends_with(y, x),
        "root": line(y, x, np.sqrt(x)),
        "saturation": terms(y, lambda p: [np.tanh(x / abs(p[0]))], [5.0]),
        "saturation, and line": terms(y, lambda p: [x, np.tanh(x / abs(p[0]))], [5.0]),
        "line that ends": curve(y, lambda p: np.minimum(p[0] + p[1] * x, END), [-2e4, 2e4]),
        "line that ends somewhere": curve(y, lambda p: np.minimum(p[0] + p[1] * x, p[2]), [-2e4, 2e4, 6.5e4]),
        "square that ends": curve(y, lambda p: np.minimum(p[0] + p[1] * x + p[2] * x**2, END), [-2e4, 2e4, 1.0]),
    }
