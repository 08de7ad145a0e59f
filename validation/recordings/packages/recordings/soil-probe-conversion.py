"""Two numbers that a soil probe makes of one measurement, the second over the first, 15 min, a summer month. The conversion is bent."""

from models.fitting import line
from readers.neptoon import soil_logger

HAND_BUILT = "square"


def rows(content):
    t, frame = soil_logger(content)
    return {"time_s": t, "first": frame[18], "second": frame[19], "soil_c": frame[20]}


def models(c):
    y, x, t, soil = c["second"], c["first"], c["time_s"], c["soil_c"]
    return y, {
        "line": line(y, x),
        HAND_BUILT: line(y, x, x**2),
        "cubic": line(y, x, x**2, x**3),
        "drift": line(y, x, t),
        "temperature": line(y, x, soil),
        "square and temperature": line(y, x, x**2, soil),
        "square and drift": line(y, x, x**2, t),
    }
