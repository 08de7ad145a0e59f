"""Heat flow of an empty channel of a calorimeter over that of another one, two days, each 40 s, from 100 min on. The room moves both; their zeros part."""

from models.fitting import line, terms
from models.lags import lag, usual
from readers.calocem import cement_calorimeter

HAND_BUILT = "drift"


def rows(content):
    frame = cement_calorimeter(content, 6000)
    return {"time_s": frame.time_s, "first_mw": frame["Kanal 7"], "second_mw": frame["Kanal 8"]}


def models(c):
    y, x, t = c["second_mw"], c["first_mw"], c["time_s"]
    return y, {
        **usual(y, x, t, 600),
        "drift, bent": line(y, x, t, t**2),
        "lag, and drift": terms(y, lambda p: [lag(x, t, abs(p[0]) * 600), t], [0.5]),
    }
