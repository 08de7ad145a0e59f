"""Pressure of carbon dioxide over sea water as a gas analyser tells it, over that which follows from alkalinity and dissolved carbon of the same water, 56 times. One laboratory measured all three."""

from models.drivers import of_drivers
from models.fitting import through_zero
from readers.cbsyst import sea_waters

HAND_BUILT = "square"


def rows(content):
    return sea_waters(content)


def models(c):
    y, x, warm = c["measured_uatm"], c["computed_uatm"] / 100, c["water_degc"]
    return y, {
        "as it is": lambda seen: x * 100,
        "gain": through_zero(y, x),
        "gain by warmth": through_zero(y, x, x * warm),
        **of_drivers(y, x, warmth=warm),
    }
