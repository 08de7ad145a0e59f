"""Nitrogen adsorbed on carbon over pressure: two kinds of site that fill up, and condensation near saturation; nothing where there is no pressure.

With a constant beside them the small pressures left out cannot be told: a block of them is then missed by any amount.
"""

import json

import pandas as pd
from models.fitting import line, terms, through_zero

HAND_BUILT = "two Langmuir terms and a line"


def rows(content):
    d = pd.DataFrame(json.loads(content)["isotherm_data"])
    return {"nitrogen_pressure": d.pressure * 1, "loading": d.loading}


def models(c):
    y, x = c["loading"], c["nitrogen_pressure"]

    def sites(p):
        return [x / (x + abs(p[0])), x / (x + abs(p[1])), x]

    def condensed(p):
        return [*sites(p), x / (abs(p[2]) + 1 - x)]

    return y, {
        "line": line(y, x),
        HAND_BUILT: terms(y, sites, [1e-6, 1e-2], through_zero),
        "and condensation": terms(y, condensed, [1e-6, 1e-2, 0.1], through_zero),
    }
