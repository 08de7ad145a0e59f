"""Thermometer of a glider's sensor for oxygen over that of the water, one dive in polar water, a row each two seconds. Two sensors of one maker, which are not read at one time."""

from models.lags import usual_and_lags
from readers.seagliderog1 import oxygen_thermometer

HAND_BUILT = "shift"


def rows(content):
    frame = oxygen_thermometer(content)
    return {"time_s": frame.time_s, "water_c": frame.water, "foil_c": frame.foil}


def models(c):
    return c["foil_c"], usual_and_lags(c["foil_c"], c["water_c"], c["time_s"], 10)
