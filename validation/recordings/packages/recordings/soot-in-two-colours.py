"""Soot in air by its shade in violet light over that in red light, on one spot of a filter, 6.6 h, a row a minute. The more is on the filter the less a colour sees, the violet first."""

from models.fitting import line
from models.lags import usual
from readers.aerosoltools import soot

HAND_BUILT = "gain by attenuation"


def rows(content):
    frame = soot(content)
    return {"time_s": frame.time_s, "red_ug_m3": frame["Red BC1"] / 1000, "attenuation": frame["UV ATN1"], "violet_ug_m3": frame["UV BC1"] / 1000}


def models(c):
    y, x, t, a = c["violet_ug_m3"], c["red_ug_m3"], c["time_s"], c["attenuation"]
    return y, {
        **usual(y, x, t),
        "attenuation": line(y, x, a),
        HAND_BUILT: line(y, x, x * a),
        "attenuation, and gain by it": line(y, x, a, x * a),
    }
