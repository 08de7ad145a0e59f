"""One thermistor of a string over another in a room, eleven months, every fourth hour. They agree but for some minutes."""

from models.lags import usual
from readers.tsp import thermistors_on_bench

HAND_BUILT = "shift"


def rows(content):
    frame = thermistors_on_bench(content)
    return {"time_s": frame.time_s, "first_c": frame[1], "second_c": frame[2]}


def models(c):
    return c["second_c"], usual(c["second_c"], c["first_c"], c["time_s"], 3600)
