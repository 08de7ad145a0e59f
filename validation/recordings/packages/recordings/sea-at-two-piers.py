"""How warm the sea is at one pier over another, a row a year, 1929 to 2006."""

from durations import YEAR
from models.drifts import usual_shifts_and_drifts
from models.fitting import line, scaled
from models.jumps import changed
from readers.pyedm import piers

HAND_BUILT = "drift, and its square"


def rows(content):
    return piers(content)


def models(c):
    y, x, t = c["scripps"], c["newport"], c["time_s"]
    u, w = scaled(x), scaled(t)
    return y, {
        **usual_shifts_and_drifts(y, x, t, YEAR),
        "drift, its square and cube": line(y, x, w, w**2, w**3),
        "drift, its square, and square": line(y, x, w, w**2, u**2),
        "drift, its square, and slope that drifts": line(y, x, w, w**2, u * w),
        "step": changed(y, t, [x], 1.0),
        "drift, and step": changed(y, t, [x, w], 1.0),
    }
