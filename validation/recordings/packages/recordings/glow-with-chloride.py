"""Light that a protein gives off at 520 nm while the colour of the lamp is swept, in 24 wells with chloride, a run a well, over the mean of three without. Chloride binds to it and darkens it."""

import numpy as np
import pandas as pd
from models.drivers import of_drivers
from models.fitting import line, terms
from readers.clophfit import plate_scans

HAND_BUILT = "bound by a law of mass"
EVERY = 4


def rows(content, notes):
    wide, told = plate_scans(content, notes, "C", 20)
    salt = told.Cl.reindex(wide.columns)
    fresh, parts = wide.loc[:, salt == 0].mean(axis=1).to_numpy(), []
    for run, well in enumerate(wide.columns[salt > 0], 1):
        row = {"run": run, "chloride_mmol": salt[well], "fresh_kcounts": fresh / 1000, "salted_kcounts": wide[well].to_numpy() / 1000}
        parts.append(pd.DataFrame(row).iloc[::EVERY])
    return pd.concat(parts, ignore_index=True)


def models(c):
    y, x, salt = c["salted_kcounts"], c["fresh_kcounts"], c["chloride_mmol"]
    free = lambda p: 1 / (1 + salt / abs(p))
    return y, {
        **of_drivers(y, x, chloride=salt),
        "slope by logarithm": line(y, x, np.log(salt), x * np.log(salt)),
        "slope that falls off": terms(y, lambda p: [x * np.exp(-salt / abs(p[0]))], [15.0]),
        "bound by a law of mass": terms(y, lambda p: [x * free(p[0])], [15.0]),
        "bound by a law of mass, and what stays": terms(y, lambda p: [x, x * free(p[0])], [15.0]),
        "bound by a law of mass, and offset": terms(y, lambda p: [x * free(p[0]), free(p[0])], [15.0]),
        "bound by a power of it": terms(y, lambda p: [x / (1 + (salt / abs(p[0])) ** p[1])], [15.0, 1.0]),
    }
