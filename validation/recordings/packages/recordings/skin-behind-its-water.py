"""Light of 2.2 um that comes back from skin over light of 1.65 um that does, three places of 100 people. Water takes both away, and tells itself at 1.45 um."""

from fitting import line, scaled
from levels import of_skin, skins
from meters import of_drivers

HAND_BUILT = "water"


def rows(content):
    return skins(content, far=2200, near=1651, water=1450)


def models(c):
    y, x, water = c["far"], c["near"], c["water"]
    v = scaled(water)
    return y, {
        **of_drivers(y, x, water=water),
        "water alone": line(y, v),
        **of_skin(y, x, c["run"], water=water),
        "water, and number": line(y, x, v, c["run"]),
    }
