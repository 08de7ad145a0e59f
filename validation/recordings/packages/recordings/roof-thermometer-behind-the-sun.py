"""Air by one thermometer on a roof over that by another there, each minute of a day. The sun shines on what they are in."""

from models.drivers import of_drivers
from models.fitting import scaled, terms
from models.lags import lag, usual_and_shifts
from readers.cpvlib import sunny_station

HAND_BUILT = "late sun"


def rows(content):
    return sunny_station(content, sun_w_m2="Gh", first_degc="Temp. Ai 1", second_degc="Temp. Ai 2")


def models(c):
    y, x, t, sun = c["second_degc"], c["first_degc"], c["time_s"], c["sun_w_m2"]
    late, u = lambda p: lag(sun, t, abs(p) * 600), scaled(x)
    return y, {
        **of_drivers(y, x, sun=sun),
        **{name: model for name, model in usual_and_shifts(y, x, t, 600).items() if name in ("drift", "shift", "lag")},
        "late sun": terms(y, lambda p: [x, late(p[0])], [8.0]),
        "late sun, and square": terms(y, lambda p: [x, u**2, late(p[0])], [8.0]),
        "late sun, and drift": terms(y, lambda p: [x, late(p[0]), t], [8.0]),
        "late sun, and lag": terms(y, lambda p: [lag(x, t, abs(p[1]) * 600), late(p[0])], [8.0, 0.2]),
        "late sun, and slope by it": terms(y, lambda p: [x, late(p[0]), u * late(p[0])], [8.0]),
        "sun and late sun": terms(y, lambda p: [x, sun, late(p[0])], [8.0]),
        "sun and lag": terms(y, lambda p: [lag(x, t, abs(p[0]) * 600), sun], [0.2]),
    }
