"""How warm the air is where it turns warmer with height, over how warm it is at the ground, a year of days in Los Angeles."""

from models.drivers import of_drivers, two_drivers
from models.fitting import line, scaled
from readers.faraway import book_table

HAND_BUILT = "gradient and height"


def rows(content):
    return book_table(content, air_degf="temp", gradient_mmhg="dpg", height_ft="ibh", base="ibt")


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
