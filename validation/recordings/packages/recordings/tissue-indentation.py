"""A ball on a soft cantilever lowered into soft tissue, every twelfth row of the way in: nothing for the most part, then contact, and a load that grows more than in proportion."""

import io

import numpy as np
import pandas as pd
from formats.packed import all_in_zip
from models.fitting import line, terms

HAND_BUILT = "exponential"


def rows(content):
    (text,) = (inside.decode("latin1").splitlines() for inside in all_in_zip(content).values())
    start = next(k for k, row in enumerate(text) if row.startswith("Time (s)"))
    d = pd.read_csv(io.StringIO("\n".join(text[start:])), sep="\t")
    d = d.iloc[: int(d["Piezo (nm)"].to_numpy().argmax()) + 1 : 12]
    return {"time_s": d["Time (s)"], "piezo_um": d["Piezo (nm)"] / 1e3, "load_un": d["Load (uN)"]}


def models(c):
    y, x = c["load_un"], c["piezo_um"]

    def contact(p):
        return [x, (np.maximum(x - 10 * p[0], 0) / 10) ** np.clip(p[1], 0.5, 4)]

    return y, {
        "line": line(y, x),
        "cubic": line(y, x, x**2, x**3),
        "hinge": terms(y, lambda p: [x, np.maximum(x - 10 * p[0], 0)], [7.5]),
        "contact, by a power": terms(y, contact, [7.2, 1.5]),
        HAND_BUILT: terms(y, lambda p: [np.exp((x - x.max()) / (0.1 + abs(p[0])))], [5.0]),
    }
