"""How deep flaws of a pipeline are, by ultrasound in the field over what a laboratory found, six batches."""

import numpy as np
from fitting import line, scaled
from monitors import bends_with
from pointers import of_book

HAND_BUILT = "square"


def rows(content):
    return of_book(content, run="Batch", field="Field", lab="Lab")


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
