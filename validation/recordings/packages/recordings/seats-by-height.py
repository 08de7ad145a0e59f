"""Where the hips of 38 drivers are behind the wheel of a car, over how tall they are."""

from models.drivers import of_drivers
from readers.faraway import book_table

HAND_BUILT = "line"


def rows(content):
    return book_table(content, age_years="Age", height_cm="Ht", hips_mm="hipcenter")


def models(c):
    return c["hips_mm"], of_drivers(c["hips_mm"], c["height_cm"], age=c["age_years"])
