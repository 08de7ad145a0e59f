"""The third thermistor of a string in the ground over the second above it, two years, each 8 hours. Heat is late."""

from models.fitting import terms
from models.lags import lag, usual
from readers.tsp import thermistor_string

HAND_BUILT = "line and lag"


def rows(content):
    frame = thermistor_string(content)
    return {"time_s": frame.time_s, "above_c": frame[2], "below_c": frame[3]}


def models(c):
    y, x, t = c["below_c"], c["above_c"], c["time_s"]
    return y, {**usual(y, x, t, 5 * 86400), HAND_BUILT: terms(y, lambda p: [x, lag(x, t, abs(p[0]) * 5 * 86400)], [1.0])}
