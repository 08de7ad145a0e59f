"""Volts of a membrane on the upper side of a wall over those of a hot wire on its lower side, beside a gauge by convection on the upper side."""

from models.drifts import usual_shifts_and_drifts
from models.drivers import of_drivers
from models.fitting import line, scaled
from readers.shield_data import permeation

HAND_BUILT = "drift, and convection"


def rows(content):
    return permeation(content, 20, "wire_v", "convection_v", "upper_v", begin=15400)


def models(c):
    y, x, t, z = c["upper_v"], c["wire_v"], c["time_s"], c["convection_v"]
    u, v, w = scaled(x), scaled(z), scaled(t)
    return y, {
        **usual_shifts_and_drifts(y, x, t, 10),
        **of_drivers(y, x, convection=z),
        "drift, and convection": line(y, x, w, v),
        "drift, and slope by convection": line(y, x, w, v, u * v),
        "drift, convection, and square": line(y, x, w, v, u**2),
        "drift, its square, and convection": line(y, x, w, w**2, v),
        "drift, convection, and slope that drifts": line(y, x, w, v, u * w),
    }
