"""Water in soil by a probe over how wet a satellite sees it as it passes, one year."""

from durations import DAY
from models.cycles import tone
from models.fitting import line, scaled, terms
from models.lags import lag, usual_and_shifts
from readers.pytesmo import wet_soil

HAND_BUILT = "year, and drift"


def rows(probe, satellite):
    return wet_soil(probe, satellite, 35)


def models(c):
    y, x, t = c["probe_m3_m3"], c["satellite_percent"], c["time_s"]
    year, v, late = tone(t, 365.2425 * DAY), scaled(t), lambda p: lag(x, t, abs(p) * 3 * DAY)
    return y, {
        **usual_and_shifts(y, x, t, 3 * DAY),
        "lag, and drift": terms(y, lambda p: [late(p[0]), v], [1.0]),
        "year": line(y, x, *year),
        "year alone": line(y, *year),
        "year, drift, and lag": terms(y, lambda p: [late(p[0]), v, *year], [1.0]),
        "year, and square": line(y, x, x**2, *year),
        "year, and drift": line(y, x, v, *year),
        "year, and slope by it": line(y, x, *year, *(x * part for part in year)),
        "year, and lag": terms(y, lambda p: [late(p[0]), *year], [1.0]),
        "year, line, and lag": terms(y, lambda p: [x, late(p[0]), *year], [1.0]),
        "two waves a year": line(y, x, *year, *tone(t, 365.2425 * DAY / 2)),
        "two waves a year, and lag": terms(y, lambda p: [late(p[0]), *year, *tone(t, 365.2425 * DAY / 2)], [1.0]),
        "drift, and its square": line(y, x, v, v**2),
    }
