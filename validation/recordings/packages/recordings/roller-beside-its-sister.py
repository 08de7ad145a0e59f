"""Heights along a roller of a bearing over those of another roller of the same bearing, rows by the place on it; a stylus goes along at one speed, so that the place stands for the clock."""

import numpy as np
from models.drifts import usual_shifts_and_drifts
from models.fitting import line, scaled, terms
from models.lags import behind, moved
from readers.tribology import near_top, profile

HAND_BUILT = "lag"
NEAR_TOP_UM, EVERY = 12, 5


def rows(first, second):
    (places, one), (_, other) = profile(first), profile(second)
    many = min(len(one), len(other))
    places, one, other = near_top(places[:many], one[:many], other[:many], below=NEAR_TOP_UM, every=EVERY)
    return {"place_mm": places, "first_um": one, "second_um": other}


def models(c):
    y, x, t = c["second_um"], c["first_um"], c["place_mm"] - c["place_mm"][0]
    w = scaled(t)
    at = lambda p: moved(x, t, p[0] * 0.05)
    return y, {
        **usual_shifts_and_drifts(y, x, t, 0.05),
        **behind(y, x, t, 0.05),
        "shift, drift, and its square": terms(y, lambda p: [at(p), w, w**2], [0.3]),
        "two waves": line(y, x, np.sin(np.pi * w), np.cos(np.pi * w)),
    }
