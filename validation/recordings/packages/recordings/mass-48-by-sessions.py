"""Mass 48 of carbon dioxide over mass 46, thirty sessions of a mass spectrometer."""

from models.bends import bends_with
from models.fitting import line, scaled
from readers.d47calib import by_session

HAND_BUILT = "square"


def rows(content):
    return by_session(content, mass_46="d46", mass_48="d48")


def models(c):
    y, x, run = c["mass_48"], c["mass_46"], c["run"]
    u, n = scaled(x), scaled(run)
    return y, {
        **bends_with(y, x, number=run),
        "fourth power": line(y, x, u**2, u**3, u**4),
        "square, and slope by number": line(y, x, u**2, n, u * n),
        "square, number, and its square": line(y, x, u**2, n, n**2),
    }
