"""Mass 47 of carbon dioxide over mass 46, thirty sessions of a mass spectrometer. Mass 45 tells of its heavy carbon."""

from models.drivers import of_drivers
from models.fitting import line, scaled
from readers.d47calib import by_session

HAND_BUILT = "all squares of mass 45"


def rows(content):
    return by_session(content, mass_46="d46", mass_45="d45", mass_47="d47")


def models(c):
    y, x, g, run = c["mass_47"], c["mass_46"], c["mass_45"], c["run"]
    u, v, n = scaled(x), scaled(g), scaled(run)
    return y, {
        **of_drivers(y, x, **{"mass 45": g}),
        "slope by mass 45, and square": line(y, x, v, u * v, u**2),
        "mass 45, and number": line(y, x, v, n),
        "slope by mass 45, and number": line(y, x, v, u * v, n),
        "slope by mass 45, number, and slope by it": line(y, x, v, u * v, n, u * n),
    }
