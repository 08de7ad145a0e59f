"""X-rays of the sun in the small one of two diodes behind one filter over the large one, two hours with a great flare. The amplifier of the sensitive one has an end."""

import numpy as np
from models.bends import usual_and_bends
from models.fitting import line, terms
from readers.sunkit_instruments import two_detectors

HAND_BUILT = "end"


def rows(content):
    return two_detectors(content, "xrsb2_flux", "xrsb1_flux", ("large_uw_m2", "small_uw_m2"))


def models(c):
    y, x, t = c["small_uw_m2"], c["large_uw_m2"], c["time_s"]
    held = lambda p: np.minimum(x, p * 100)
    return y, {
        **usual_and_bends(y, x, t, 10),
        "end": terms(y, lambda p: [held(p[0])], [6.0]),
        "end, and drift": terms(y, lambda p: [held(p[0]), t], [6.0]),
        "end, and square": terms(y, lambda p: [held(p[0]), held(p[0]) ** 2], [6.0]),
        "square, and drift": line(y, x, x**2, t),
    }
