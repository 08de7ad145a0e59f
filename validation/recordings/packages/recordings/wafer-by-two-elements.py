"""Two elements of the Mueller matrix of a wafer under oxide, at 1841 wavelengths from 210 to 1000 nm. The wafer looks the same from all sides, so that both must be one."""

import numpy as np
from models.fitting import line, through_zero
from readers.pyelli import mueller

HAND_BUILT = "as it is"


def rows(content):
    elements = mueller(content, (210, 1000))[1]
    return {"first_element": elements[1], "second_element": elements[4]}


def models(c):
    y, x = c["second_element"], c["first_element"]
    order = np.arange(len(y)) / len(y)
    return y, {
        "as it is": lambda seen: x,
        "gain": through_zero(y, x),
        "line": line(y, x),
        "square": line(y, x, x**2),
        "cube": line(y, x, x**2, x**3),
        "order": line(y, x, order),
    }
