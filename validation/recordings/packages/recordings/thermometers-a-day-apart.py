"""The warmest of a day at Vero Beach over that at Fort Pierce, 20 km away, ten years. One of them was read in the morning, and what it told was that of the day before."""

from durations import DAY
from models.cycles import tone
from models.fitting import line, terms
from models.lags import late_shifts, moved
from readers.mettoolbox import thermometers

HAND_BUILT = "shift, and square"


def rows(content):
    return thermometers(content, "FTPR", "VERO", "1967", "1976")


def models(c):
    y, x, t = c["here_degc"], c["there_degc"], c["time_s"]
    return y, {
        **late_shifts(y, x, t, DAY, 0.9),
        "year": line(y, x, *tone(t, 365.25 * DAY)),
        "shift from there, and year": terms(y, lambda p: [moved(x, t, p[0] * DAY), *tone(t, 365.25 * DAY)], [0.9]),
    }
