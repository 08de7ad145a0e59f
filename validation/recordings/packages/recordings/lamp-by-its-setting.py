"""Light of a violet lamp over its setting, by a spectrometer where an eye would be."""

from fitting import line, scaled
from monitors import bends_with
from tellers import one_side, setting

HAND_BUILT = "power"


def rows(content):
    return setting(content, 0)


def models(c):
    y, x = c["light"], c["setting"]
    u = scaled(x)
    return y, {
        **bends_with(y, x),
        "fourth power": line(y, x, u**2, u**3, u**4),
        **one_side(y, x, 1000.0),
    }
