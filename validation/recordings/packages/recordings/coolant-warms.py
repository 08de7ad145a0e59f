"""Temperature of the coolant of a hybrid car that starts at 25 degC, half an hour on rollers. It warms, less and less."""

import numpy as np
from models.fitting import line, terms
from readers.co2mpas import car_on_rollers

HAND_BUILT = "drift, and its square"


def rows(content):
    frame = car_on_rollers(content)
    return {"time_s": frame.times, "coolant_c": frame.engine_coolant_temperatures}


def models(c):
    y, t = c["coolant_c"], c["time_s"]
    fading = lambda p: np.exp(-t / (abs(p) * 300 + 1))
    return y, {
        "constant": line(y),
        "drift": line(y, t),
        "drift, and its square": line(y, t, t**2),
        "drift that fades": terms(y, lambda p: [fading(p[0])], [1.0]),
        "drift that fades, and drift": terms(y, lambda p: [fading(p[0]), t], [1.0]),
        "logarithm": terms(y, lambda p: [np.log1p(t / (abs(p[0]) * 100 + 1))], [1.0]),
        "two drifts that fade": terms(y, lambda p: [fading(p[0]), fading(p[1])], [0.2, 2.0]),
    }
