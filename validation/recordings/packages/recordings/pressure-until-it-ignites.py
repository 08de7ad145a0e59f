"""Pressure of a mixture that burns over that of one that cannot, both compressed by the same piston, until the first ignites. The recorders did not begin at the same stroke."""

from models.fitting import line, scaled, terms
from models.lags import behind, moved, usual_and_shifts
from readers.uconnrcmpy import two_shots

HAND_BUILT = "shift, and drift"


def rows(*contents):
    return two_shots(*contents, first=13000, last=22500, every=25)


def models(c):
    y, x, t = c["second_v"], c["first_v"], c["time_s"]
    u, w, unit = scaled(x), scaled(t), 0.003
    at = lambda p: moved(x, t, p * unit)
    return y, {
        **usual_and_shifts(y, x, t, unit),
        "cube": line(y, x, u**2, u**3),
        "drift, and slope that drifts": line(y, x, w, u * w),
        **behind(y, x, t, unit),
        "shift, drift, and square": terms(y, lambda p: [at(p[0]), at(p[0]) ** 2, w], [0.5]),
        "shift, drift, and its square": terms(y, lambda p: [at(p[0]), w, w**2], [0.5]),
        "shift, drift, and slope that drifts": terms(y, lambda p: [at(p[0]), w, u * w], [0.5]),
    }
