"""Thermometer of a glider's optode over that of the water, one dive from 30 to 13 degC. The optode is behind the water."""

from models.lags import usual_and_lags
from readers.seagliderog1 import warm_glider

HAND_BUILT = "two lags"


def rows(content):
    frame = warm_glider(content, 4, 4, 3, "water", "optode")
    return {"time_s": frame.time_s, "water_c": frame.water, "optode_c": frame.optode}


def models(c):
    return c["optode_c"], usual_and_lags(c["optode_c"], c["water_c"], c["time_s"], 20)
