"""Temperature along a cable by scattered light, 98 m through warm and cold water, beside the same five seconds before. They agree."""

from models.fitting import line
from readers.dtscalibration import fibre

HAND_BUILT = "line"


def rows(before, after):
    first, second = fibre(before), fibre(after)
    return {"along_m": first.along, "first_c": first.degc, "second_c": second.degc}


def models(c):
    y, x, along = c["second_c"], c["first_c"], c["along_m"]
    return y, {
        HAND_BUILT: line(y, x),
        "square": line(y, x, x**2),
        "length": line(y, x, along),
        "length and its square": line(y, x, along, along**2),
        "gain by length": line(y, x, along * x),
    }
