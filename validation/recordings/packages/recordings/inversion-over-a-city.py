"""How warm the air is where it turns warmer with height, over how warm it is at the ground, a year of days in Los Angeles."""

from fitting import line, scaled
from meters import of_drivers
from pointers import of_book, two_drivers

HAND_BUILT = "gradient and height"


def rows(content):
    return of_book(content, air_degf="temp", gradient_mmhg="dpg", height_ft="ibh", base="ibt")


def models(c):
    y, x, drivers = c["base"], c["air_degf"], {"gradient": c["gradient_mmhg"], "height": c["height_ft"]}
    u, (gradient, height) = scaled(x), (scaled(values) for values in drivers.values())
    return y, {
        **of_drivers(y, x, **drivers),
        **two_drivers(y, x, **drivers),
        "slope by gradient alone": line(y, x, u * gradient),
        "slope by height alone": line(y, x, u * height),
        "height, and slope by gradient alone": line(y, x, height, u * gradient),
    }
