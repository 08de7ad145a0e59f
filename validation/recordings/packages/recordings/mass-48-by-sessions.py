"""Mass 48 of carbon dioxide over mass 46, thirty sessions of a mass spectrometer."""

from fitting import line, scaled
from listeners import by_session
from monitors import bends_with

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
