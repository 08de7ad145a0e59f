"""Temperature inside of a house: heating and outside pass a heat store and a resistance, two slow lags."""

import pandas as pd
from formats.clock import seconds
from formats.text import csv
from models.fitting import line, terms
from models.lags import lag

HAND_BUILT = "two lags of heating and outside"


def rows(content):
    d = csv(content)
    return {"time_s": seconds(pd.to_datetime(d.iloc[:, 0])), "heating_kw": d.Ph / 1, "outside_c": d.Ta, "inside_c": d.Ti}


def models(c):
    y, t, heat, outside = c["inside_c"], c["time_s"], c["heating_kw"], c["outside_c"]

    def lags(p):
        return [lag(column, t, abs(tau)) for tau in p for column in (heat, outside)]

    return y, {"line": line(y, heat), "one lag": terms(y, lags, [36000.0]), HAND_BUILT: terms(y, lags, [7200.0, 3e5])}
