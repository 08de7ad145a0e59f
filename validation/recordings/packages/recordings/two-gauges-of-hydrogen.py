"""Volts of a membrane over those of a gauge by convection, both on the upper side of a wall, the last hour and a half of a run."""

from models.drifts import usual_shifts_and_drifts
from models.fitting import line, scaled, terms
from models.lags import moved
from readers.shield_data import permeation

HAND_BUILT = "drift"


def rows(content):
    return permeation(content, 20, "convection_v", "upper_v", begin=15400)


def models(c):
    y, x, t = c["upper_v"], c["convection_v"], c["time_s"]
    u, w = scaled(x), scaled(t)
    return y, {
        **usual_shifts_and_drifts(y, x, t, 10),
        "drift, and cube": line(y, x, w, u**2, u**3),
        "drift, and shift": terms(y, lambda p: [moved(x, t, p[0]), w], [1.0]),
        "drift, its square, and square": line(y, x, w, w**2, u**2),
    }
