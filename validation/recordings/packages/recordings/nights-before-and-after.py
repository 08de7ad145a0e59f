"""The coldest of a night at Gainesville over that at Ocala, each second night of eleven years. In October 1988 a thermometer was moved, or read at another hour."""

from durations import DAY
from models.cycles import tone
from models.fitting import line
from models.jumps import switched_at
from models.lags import usual
from readers.mettoolbox import thermometers

HAND_BUILT = "step, and year"
MOVED = 1739 * DAY


def rows(content):
    return thermometers(content, "OCALA", "GAINU", "1984", "1994", every=2)


def models(c):
    y, x, t = c["here_degc"], c["there_degc"], c["time_s"]
    year = tone(t, 365.25 * DAY)
    return y, {
        **usual(y, x, t, DAY),
        **switched_at(y, x, t, MOVED),
        "year": line(y, x, *year),
        "step, and year": line(y, x, t > MOVED, *year),
        "step, slope, and year": line(y, x, t > MOVED, x * (t > MOVED), *year),
    }
