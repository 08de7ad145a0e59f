"""A ball with air and one with helium, kicked in turn 39 times: the gas makes no difference, practice makes a little."""

import numpy as np
from models.fitting import line
from readers.rdatasets import frame

HAND_BUILT = "line"


def rows(content):
    d = frame(content)
    both = d[["air", "helium"]].to_numpy().ravel()
    return {"trial": np.repeat(d.trial, 2), "helium": np.arange(len(both)) % 2, "distance_yd": both}


def models(c):
    y, trial, gas = c["distance_yd"], c["trial"], c["helium"]
    return y, {HAND_BUILT: line(y, trial), "gas": line(y, trial, gas), "square": line(y, trial, trial**2)}
