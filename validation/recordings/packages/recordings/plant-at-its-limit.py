"""Power of a plant of solar modules over that which its model expects, each fifth hour of day in a year. The plant may give no more than 20 MW."""

import numpy as np
from models.fitting import curve, line, terms, through_zero
from readers.pvops import solar_plant

HAND_BUILT = "line, and end"


def rows(content):
    read = solar_plant(content, "R10", 5)
    return {"time_s": read.time_s, "module_degc": read.temp_mod_C, "expected_kw": read.expected_kW, "told_kw": read.generated_kW}


def models(c):
    y, x, warm, t = c["told_kw"], c["expected_kw"], c["module_degc"], c["time_s"]
    most = lambda p: np.minimum(x, abs(p) * 1e4)
    return y, {
        "as it is": lambda seen: x,
        "gain": through_zero(y, x),
        "line": line(y, x),
        "square": line(y, x, x**2),
        "line, and warmth": line(y, x, warm, x * warm),
        "end": curve(y, lambda p: most(p[0]), [2.0]),
        "gain, and end": terms(y, lambda p: [most(p[0])], [2.0], through_zero),
        "line, and end": terms(y, lambda p: [most(p[0])], [2.0]),
        "gain, end, and drift": terms(y, lambda p: [most(p[0]), t], [2.0]),
        "gain that drifts, and end": terms(y, lambda p: [most(p[0]), t * most(p[0])], [2.0], through_zero),
        "gain by warmth, and end": terms(y, lambda p: [most(p[0]), warm * most(p[0])], [2.0], through_zero),
    }
