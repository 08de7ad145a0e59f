"""Power of an inverter of a solar plant over that of another, five days, each five minutes. They agree."""

from models.lags import usual
from readers.captest import solar_plant

HAND_BUILT = "line"


def rows(content):
    frame = solar_plant(content)
    return {"time_s": frame.time_s, "first_kw": frame.inv1_power / 1000, "eighth_kw": frame.inv8_power / 1000}


def models(c):
    y, x, t = c["eighth_kw"], c["first_kw"], c["time_s"]
    return y, usual(y, x, t, 600)
