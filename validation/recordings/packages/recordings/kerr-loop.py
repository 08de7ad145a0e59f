"""Light that a magnetic film turns over the field, one turn of a field that goes as a sine. The film has a loop."""

from formats.clock import since_first
from formats.text import csv
from models.fitting import terms
from models.lags import lag
from readers.stoner import loop_models

HAND_BUILT = "saturation at a field by direction"


def rows(content):
    frame = csv(content, sep=r"\s+", skiprows=3, header=None)
    return {"time_s": since_first(frame[0]), "field_a_m": frame[1], "light_mv": frame[3] * 1000}


def models(c):
    y, x, t = c["light_mv"], c["field_a_m"], c["time_s"]
    return y, {**loop_models(y, x, 50.0, 650.0), "lag": terms(y, lambda p: [lag(x, t, abs(p[0]) * 1e-3)], [1.0])}
