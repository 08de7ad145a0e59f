"""The clock of a radio telescope against that of the satellites, 13 months until it is tuned anew, a row each 5.6 hours. Its rate is off, and changes."""

import numpy as np
from models.fitting import line, terms
from readers.pint_pulsar import telescope_clock

HAND_BUILT = "square"


def rows(content):
    t, ahead = telescope_clock(content, 57960, 58373)
    return {"time_s": t[::2].round(1), "ahead_us": ahead[::2]}


def models(c):
    y, t = c["ahead_us"], c["time_s"]
    share = t / t[-1]
    return y, {
        "constant": line(y),
        "drift": line(y, t),
        HAND_BUILT: line(y, share, share**2),
        "cubic": line(y, share, share**2, share**3),
        "exponential": terms(y, lambda p: [np.expm1(p[0] * share)], [0.7]),
        "logarithm": terms(y, lambda p: [np.log1p(share / (abs(p[0]) + 1e-3))], [0.5]),
    }
