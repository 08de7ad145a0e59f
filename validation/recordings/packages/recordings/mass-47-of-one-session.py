"""Mass 47 of carbon dioxide over mass 46, a session of a mass spectrometer. Mass 47 has a heavy carbon as well, which mass 45 tells."""

from models.drifts import usual_shifts_and_drifts
from models.drivers import of_drivers
from models.fitting import line, scaled
from readers.d47calib import one_session

HAND_BUILT = "mass 45, and slope by it"


def rows(content):
    return one_session(content, 1, mass_46="d46", mass_45="d45", mass_47="d47")


def models(c):
    y, x, g, t = c["mass_47"], c["mass_46"], c["mass_45"], c["time_s"]
    u, v, w = scaled(x), scaled(g), scaled(t)
    return y, {
        **usual_shifts_and_drifts(y, x, t, 3600),
        **of_drivers(y, x, **{"mass 45": g}),
        "mass 45, and slope by it": line(y, x, v, u * v),
        "mass 45, slope by it, and square": line(y, x, v, u * v, u**2),
        "mass 45, and drift": line(y, x, v, w),
        "mass 45, slope by it, and drift": line(y, x, v, u * v, w),
        "mass 45, slope by it, and slope that drifts": line(y, x, v, u * v, w, u * w),
    }
