"""Breakdown voltage of insulation over weeks in an oven: it ages, faster where it is hotter; the model is the certified one of NIST."""

import numpy as np
from formats.nist import nist
from models.fitting import curve, line

HAND_BUILT = "exp(b1 - b2 age exp(b3 temperature))"


def rows(content):
    d = nist(content, ["breakdown_kv", "age_weeks", "oven_c"])
    return {name: d[name] for name in ("age_weeks", "oven_c", "breakdown_kv")}


def models(c):
    y, age, oven = c["breakdown_kv"], c["age_weeks"], c["oven_c"]
    ageing = curve(y, lambda p: np.exp(p[0] - p[1] * age * np.exp(p[2] * (oven - 250) / 10)), [2.6, 0.01, 0.4])
    return y, {"line": line(y, oven), "line in both": line(y, oven, age), HAND_BUILT: ageing}
