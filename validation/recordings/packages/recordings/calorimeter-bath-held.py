"""Temperature of the bath of a calorimeter that is held at 20 degC, beside that of the room, 44 hours, every third row of its file from the fourth hour on. It is held."""

from models.fitting import line, terms
from models.lags import lag
from readers.calocem import thermostat

HAND_BUILT = "constant"


def rows(content):
    frame = thermostat(content, 14400, 3)
    return {"time_s": frame.time_s, "room_c": frame.room, "bath_c": frame.bath}


def models(c):
    y, x, t = c["bath_c"], c["room_c"], c["time_s"]
    return y, {
        HAND_BUILT: line(y),
        "drift": line(y, t),
        "room": line(y, x),
        "late room": terms(y, lambda p: [lag(x, t, abs(p[0]) * 600)], [1.0]),
        "drift, and room": line(y, x, t),
    }
