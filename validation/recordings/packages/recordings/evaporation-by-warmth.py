"""What grass would evaporate in Nebraska over the warmest of the day, each second day of six years. Vapour in warm air grows ever faster, and June has more sun than August."""

from durations import DAY
from models.bends import bends_with
from models.cycles import tone
from models.fitting import line, scaled
from readers.aquacrop import evaporation

HAND_BUILT = "square, year, and slope by it"
YEAR = 365.2422 * DAY


def rows(content):
    return evaporation(content, 2012, 2018, 2)


def models(c):
    y, x, t = c["evaporation_mm"], c["warmest_degc"], c["time_s"]
    u, year = scaled(x), [*tone(t, YEAR), *tone(t, YEAR / 2)]
    return y, {
        **bends_with(y, x, drift=scaled(t)),
        "year": line(y, x, *year),
        "square, and one wave a year": line(y, x, u**2, *year[:2]),
        "square, and year": line(y, x, u**2, *year),
        "cube, and year": line(y, x, u**2, u**3, *year),
        "square, year, and slope by it": line(y, x, u**2, *year, *(u * k for k in year[:2])),
    }
