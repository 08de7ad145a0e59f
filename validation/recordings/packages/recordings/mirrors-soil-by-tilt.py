"""Reflectance of mirrors that dust settles on over that of a flat one beside them, three campaigns at one place, a run a mirror. The steeper a mirror, the less settles."""

import numpy as np
from models.fitting import line
from readers.mirror_soiling_data import mirrors

HAND_BUILT = "dust by the cosine, and drift by it"


def rows(*contents):
    return mirrors(contents)


def models(c):
    y, x, t, tilt = c["mirror_pct"], c["flat_pct"], c["time_s"], c["tilt_deg"]
    level = np.cos(np.radians(tilt))
    return y, {
        "line": line(y, x),
        "square": line(y, x, x**2),
        "drift": line(y, x, t),
        "tilt": line(y, x, tilt),
        "slope by tilt": line(y, x, tilt, x * tilt),
        "slope by tilt, and square": line(y, x, tilt, x * tilt, x**2),
        "slope by tilt, and drift": line(y, x, tilt, x * tilt, t),
        "dust by the cosine of the tilt": line(y, x, level, x * level),
        "dust by the cosine, and square": line(y, x, level, x * level, x**2),
        "dust by the cosine, and drift": line(y, x, level, x * level, t),
        "dust by the cosine, and drift by it": line(y, x, level, x * level, t, t * level),
        "slope by tilt, bent": line(y, x, tilt, x * tilt, tilt**2, x * tilt**2),
    }
