"""Heat flow of setting cement in one channel of a calorimeter over that of its neighbour, which holds the same cement, two days, each 40 s, from 100 min on. They agree."""

from models.lags import usual
from readers.calocem import cement_calorimeter

HAND_BUILT = "line"


def rows(content):
    frame = cement_calorimeter(content, 6000)
    return {"time_s": frame.time_s, "first_mw": frame["Kanal 5"], "second_mw": frame["Kanal 6"]}


def models(c):
    y, x, t = c["second_mw"], c["first_mw"], c["time_s"]
    return y, usual(y, x, t, 600)
