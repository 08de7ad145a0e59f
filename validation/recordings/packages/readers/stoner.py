"""Reads files of the package stoner, and holds models that its recordings share."""

import numpy as np
import pandas as pd
from formats.text import csv
from models.fitting import line, terms


def tagged_table(content):
    """Columns of numbers of a table whose first column holds the settings of the measurement."""
    return csv(content, sep="\t", encoding="latin1").iloc[:, 1:].apply(pd.to_numeric, errors="coerce")


def loop_models(y, x, width, shift):
    """Models of a hysteresis loop `y` over `x`: the field at which it turns over is another on the way up and down."""
    against = np.sign(np.gradient(x))
    step = lambda p: np.tanh((x - p[1] * against) / abs(p[0]))
    return {
        "line": line(y, x),
        "cubic": line(y, x, x**2, x**3),
        "direction": line(y, x, against),
        "saturation": terms(y, lambda p: [x, np.tanh(x / abs(p[0]))], [width]),
        "direction, and saturation": terms(y, lambda p: [x, against, np.tanh(x / abs(p[0]))], [width]),
        "saturation at a field by direction": terms(y, lambda p: [x, step(p)], [width, shift]),
    }
