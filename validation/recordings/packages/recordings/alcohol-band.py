"""How much light of 1045 1/cm a broth takes away over that of 1085 1/cm, 34 h of a fermentation. Alcohol takes away more of the first, sugar more of the second."""

from durations import HOUR
from models.drifts import usual_and_drifts
from models.fitting import terms
from models.jumps import soft_step, switched_at
from readers.chemotools import bands

HAND_BUILT = "switch"


def rows(content):
    return bands(content, 75, 1085, 1045)


def models(c):
    y, x, t = c["band_1045"], c["band_1085"], c["time_s"]
    then = lambda p: soft_step(t, p[0] * HOUR, abs(p[1]) * HOUR)
    return y, {
        **usual_and_drifts(y, x, t),
        **switched_at(y, x, t, 16.7 * HOUR),
        "switch": terms(y, lambda p: [x, then(p)], [15.0, 1.0]),
        "switch, and drift": terms(y, lambda p: [x, then(p), t], [15.0, 1.0]),
        "switch, and slope": terms(y, lambda p: [x, then(p), x * then(p)], [15.0, 1.0]),
    }
