"""Nitrogen dioxide at a road over that away from it, means of the days of three years. Wind takes away what the cars give off."""

from durations import DAY, YEAR
from models.cycles import tone
from models.drivers import of_drivers
from models.fitting import line, scaled
from readers.aqeval import road

HAND_BUILT = "wind, bent, drift, and week"


def rows(content):
    return road(content)


def models(c):
    y, x, t, wind = c["road"], c["background"], c["time_s"], c["wind_m_s"]
    week, year, v = tone(t, 7 * DAY), tone(t, YEAR), scaled(t)
    return y, {
        **of_drivers(y, x, wind=wind),
        "one over wind": line(y, x, 1 / (wind + 0.5)),
        "drift": line(y, x, v),
        "week": line(y, x, *week),
        "year": line(y, x, *year),
        "wind, and drift": line(y, x, wind, v),
        "wind, bent, and drift": line(y, x, wind, wind**2, v),
        "wind, and week": line(y, x, wind, *week),
        "wind, and year": line(y, x, wind, *year),
        "wind, bent, drift, and week": line(y, x, wind, wind**2, v, *week),
    }
