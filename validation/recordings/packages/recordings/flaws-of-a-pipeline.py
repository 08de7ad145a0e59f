"""How deep flaws of a pipeline are, by ultrasound in the field over what a laboratory found, six batches."""

import numpy as np
from models.bends import bends_with
from models.fitting import line, scaled
from readers.faraway import book_table

HAND_BUILT = "square"


def rows(content):
    return book_table(content, run="Batch", field="Field", lab="Lab")


def models(c):
    y, x, run = c["field"], c["lab"], c["run"]
    w, each = scaled(run), [run == k for k in np.unique(run)[1:]]
    return y, {
        "as it is": lambda seen: x,
        "zero": lambda seen: x + np.mean((y - x)[seen]),
        **bends_with(y, x),
        "logarithm": line(y, np.log(x)),
        "number": line(y, x, w),
        "slope by number": line(y, x, w, x * w),
        "square, and number": line(y, x, scaled(x) ** 2, w),
        "zero of each batch": line(y, x, *each),
        "slope of each batch": line(y, x, *(x * one for one in each)),
    }
