"""Light of a violet lamp over its setting, by a spectrometer where an eye would be."""

from models.bends import bends_with, levels_off
from models.fitting import line, scaled
from readers.pysilsub import lamp_by_setting

HAND_BUILT = "power"


def rows(content):
    return lamp_by_setting(content, 0)


def models(c):
    y, x = c["light"], c["setting"]
    u = scaled(x)
    return y, {
        **bends_with(y, x),
        "fourth power": line(y, x, u**2, u**3, u**4),
        **levels_off(y, x, 1000.0),
    }
