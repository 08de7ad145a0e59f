"""Temperature of the ground as a radiometer in orbit told it over that of the air at a tower, 1038 passes over many towers. The sun warms the ground, and leaves cool it."""

from models.drivers import of_drivers
from models.fitting import line
from readers.ecov002_calval_tables import towers

HAND_BUILT = "sun, green, and their product"
NAMES = ["AirTempC", "SW_IN", "NDVI", "LST"]


def rows(content):
    read = towers(content, *NAMES)
    return {"air_degc": read.AirTempC, "sun_w_m2": read.SW_IN, "green": read.NDVI, "ground_degc": read.LST - 273.15}


def models(c):
    y, x, sun, green = c["ground_degc"], c["air_degc"] / 10, c["sun_w_m2"] / 500, c["green"]
    return y, {
        **of_drivers(y, x, sun=sun, green=green),
        "sun, and green": line(y, x, sun, green),
        "sun, green, and their product": line(y, x, sun, green, sun * green),
        "sun, and green, and slopes by both": line(y, x, sun, green, x * sun, x * green),
        "sun, bent, and green, and slopes by both": line(y, x, sun, sun**2, green, x * sun, x * green, sun * green),
    }
