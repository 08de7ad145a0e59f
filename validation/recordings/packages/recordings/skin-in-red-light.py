"""Red light that comes back from skin over infrared light that does, three places of 100 people. Green light tells how dark the skin is and how much blood it holds."""

from models.drivers import of_drivers
from models.fitting import line, scaled
from readers.iadpython import skin_models, skins

HAND_BUILT = "all squares of green"


def rows(content):
    return skins(content, green=544, infrared=940, red=661)


def models(c):
    y, x, green = c["red"], c["infrared"], c["green"]
    v = scaled(green)
    return y, {
        **of_drivers(y, x, green=green),
        "green alone": line(y, v, v**2),
        **skin_models(y, x, c["run"], green=green),
        "green, bent, and number": line(y, x, v, v**2, c["run"]),
    }
