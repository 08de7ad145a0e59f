"""How much later radio of four stations comes to a receiver than distances say, in m, 79 seconds. The clock of the receiver is not that of the stations, and is set anew on the way."""

from models.drifts import courses
from models.fitting import scaled
from models.jumps import changed
from readers.pnt_datasets import clock

HAND_BUILT = "drift, and step"


def rows(measured, places, stations):
    return clock(measured, places, stations)


def models(c):
    y, t = c["late_m"], c["time_s"]
    w = scaled(t)
    return y, {
        **courses(y, t),
        "drift from then on": changed(y, t, [], w),
        "drift, and another from then on": changed(y, t, [w], w),
    }
