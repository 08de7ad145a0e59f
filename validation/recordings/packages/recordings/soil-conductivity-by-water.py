"""Electrical conductivity of soil over the water that the same rod of a probe finds in it, beside its temperature, three weeks of spring with some rain, a row each half hour. The meter tells nothing below some water, and more than a line above."""

import numpy as np
from models.fitting import line, terms
from models.lags import usual
from readers.soil_heat import half_hours

HAND_BUILT = "square, and temperature"


def rows(content):
    frame = half_hours(content, "VWC_1_2_1", "T_1_2_1", "BulkEC_1_2_1")
    return {"time_s": frame.time_s, "water": frame.VWC_1_2_1, "soil_c": frame.T_1_2_1, "conductivity_ds_m": frame.BulkEC_1_2_1}


def models(c):
    y, x, t, warm = c["conductivity_ds_m"], c["water"], c["time_s"], c["soil_c"]
    above = lambda p: np.maximum(x - abs(p), 0)
    return y, {
        **usual(y, x, t, 3600),
        "temperature": line(y, x, warm),
        "gain by temperature": line(y, x, x * warm),
        HAND_BUILT: line(y, x, x**2, warm),
        "square, and gain by temperature": line(y, x, x**2, x * warm),
        "corner": terms(y, lambda p: [above(p[0])], [0.12]),
        "corner, and temperature": terms(y, lambda p: [above(p[0]), warm], [0.12]),
        "corner, and gain by temperature": terms(y, lambda p: [above(p[0]), above(p[0]) * warm], [0.12]),
    }
