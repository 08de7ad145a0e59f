"""Bath of a calorimeter against its 20 degC over three days, in which the room cools by 0.9 K: it does not see the room."""

import numpy as np
from formats.text import csv
from models.fitting import line

HAND_BUILT = "constant"


def rows(content):
    d = csv(content)
    t, room, bath = (d[name] for name in ("Time", "Temperature [AmbientT(Therm3T)]", "Temperature [Temperature]"))
    kept = t.notna() & room.notna() & bath.notna() & (t.diff().fillna(1) > 0)
    return {"time_s": t[kept].round(2), "room_c": room[kept], "bath_mk": (bath[kept] - 20) * 1e3}


def models(c):
    y, t = c["bath_mk"], c["time_s"]
    return y, {"constant": line(y), "room": line(y, c["room_c"]), "drift": line(y, t), "settles": line(y, np.exp(-t / 3600))}
