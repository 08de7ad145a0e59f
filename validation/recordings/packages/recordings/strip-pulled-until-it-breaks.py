"""Force on a strip of a polymer that is pulled at one speed until it breaks. It is stiffest at the beginning."""

import numpy as np
from models.fitting import line, scaled, terms
from models.lags import behind, usual_and_shifts
from readers.process_nitta import pulled_strip

HAND_BUILT = "line, and logarithm"


def rows(content):
    return pulled_strip(content, 4)


def models(c):
    y, x, t = c["force_n"], c["stroke_mm"], c["time_s"]
    u, soft = scaled(x), lambda p: 1 - np.exp(-x / abs(p))
    return y, {
        **usual_and_shifts(y, x, t, 10),
        "cube": line(y, x, u**2, u**3),
        "fourth power": line(y, x, u**2, u**3, u**4),
        "line, and logarithm": line(y, x, np.log(x + 0.25)),
        "line, square, and logarithm": line(y, x, u**2, np.log(x + 0.25)),
        "root": line(y, x, np.sqrt(x)),
        **behind(y, x, t, 10),
        "curve that levels off": terms(y, lambda p: [soft(p[0])], [10.0]),
        "curve that levels off, and line": terms(y, lambda p: [x, soft(p[0])], [3.0]),
        "curve that levels off, and square": terms(y, lambda p: [x, u**2, soft(p[0])], [3.0]),
        "two curves that level off": terms(y, lambda p: [x, soft(p[0]), soft(p[1])], [3.0, 0.5]),
    }
