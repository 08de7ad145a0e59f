"""Light of 2.2 um that comes back from skin over light of 1.65 um that does, three places of 100 people. Water takes both away, and tells itself at 1.45 um."""

from models.drivers import of_drivers
from models.fitting import line, scaled
from readers.iadpython import skin_models, skins

HAND_BUILT = "water"


def rows(content):
    return skins(content, far=2200, near=1651, water=1450)


def models(c):
    y, x, water = c["far"], c["near"], c["water"]
    v = scaled(water)
    return y, {
        **of_drivers(y, x, water=water),
        "water alone": line(y, v),
        **skin_models(y, x, c["run"], water=water),
        "water, and number": line(y, x, v, c["run"]),
    }
