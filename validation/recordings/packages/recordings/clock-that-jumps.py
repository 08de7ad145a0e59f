"""How much later radio of four stations comes to a receiver than distances say, in m, 79 seconds. The clock of the receiver is not that of the stations, and is set anew on the way."""

from models.drifts import fades
from models.fitting import line, scaled, terms
from models.jumps import changed
from readers.pnt_datasets import clock

HAND_BUILT = "drift, and step"


def rows(measured, places, stations):
    return clock(measured, places, stations)


def models(c):
    y, t = c["late_m"], c["time_s"]
    w = scaled(t)
    return y, {
        "constant": line(y),
        "drift": line(y, w),
        "drift, and its square": line(y, w, w**2),
        "drift, its square and cube": line(y, w, w**2, w**3),
        "drift to a rest": terms(y, lambda p: [fades(t, p[0])], [0.3]),
        "step": changed(y, t, [], 1.0),
        "drift from then on": changed(y, t, [], w),
        "drift, and step": changed(y, t, [w], 1.0),
        "drift, and another from then on": changed(y, t, [w], w),
    }
