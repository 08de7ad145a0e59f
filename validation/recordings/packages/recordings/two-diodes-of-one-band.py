"""X-rays of the sun in two diodes behind one filter, a flare that is small enough for both. Next to nothing is missing."""

from models.bends import usual_and_bends
from models.fitting import line
from readers.sunkit_instruments import two_detectors

HAND_BUILT = "slope that drifts"


def rows(content):
    return two_detectors(content, "xrsa1_flux", "xrsa2_flux", ("small_uw_m2", "large_uw_m2"))


def models(c):
    y, x, t = c["large_uw_m2"], c["small_uw_m2"], c["time_s"]
    return y, {**usual_and_bends(y, x, t, 10), "square, and drift": line(y, x, x**2, t), "slope that drifts": line(y, x, t, x * t)}
