"""Reads files of the package citylearn, and holds models that its recordings share."""

import numpy as np
from durations import HOUR
from formats.text import csv
from models.fitting import line


def roofs(first, second, begin, end, least):
    """What the solar cells of two houses give in the hours between two days since the first, while both give so much; seconds since the first hour."""
    here, there = (csv(content)["Solar Generation [W/kW]"].to_numpy()[begin * 24 : end * 24] for content in (first, second))
    kept = (here > least) & (there > least)
    hours = np.flatnonzero(kept)
    return {"time_s": (hours - hours[0]) * HOUR, "first_w_kw": here[kept], "second_w_kw": there[kept]}


def changed_at_best(y, x, t, places):
    """Models of a zero and a slope that are others from some time on: that of the places, as parts of the whole, at which the line fits best."""
    from_there = [(t > t[0] + place * (t[-1] - t[0])).astype(float) for place in places]
    best = lambda of: min(of, key=lambda term: np.std(y - line(y, x, term)(np.ones(len(y), bool))))
    zero, slope = best(from_there), best([x * step for step in from_there])
    others = {"step": zero, "drift": t, "slope that drifts": x * t}
    return {
        "step": line(y, x, zero),
        "slope that changes": line(y, x, slope),
        **{f"slope that changes, and {name}": line(y, x, slope, term) for name, term in others.items()},
    }
