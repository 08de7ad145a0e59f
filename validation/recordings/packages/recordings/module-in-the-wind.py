"""Warmth of a solar module's back over that of the air, each minute of three days while the sun shines. Wind takes away what the sun brings."""

from models.drivers import of_drivers
from models.fitting import line, scaled, terms
from models.lags import lag, usual_and_shifts
from readers.cpvlib import solar_module

HAND_BUILT = "square, and wind"


def rows(content):
    return solar_module(content, "2019-06-02", "2019-06-05", 100)


def models(c):
    y, x, t, wind = c["back_degc"], c["air_degc"], c["time_s"], c["wind_m_s"]
    v, w, late = scaled(wind), scaled(t), lambda p: lag(wind, t, abs(p) * 300)
    return y, {
        **of_drivers(y, x, wind=wind),
        **{name: model for name, model in usual_and_shifts(y, x, t, 300).items() if name in ("drift", "shift", "lag")},
        "wind, and drift": line(y, x, v, w),
        "wind, and its root": line(y, x, v, wind**0.5),
        "late wind": terms(y, lambda p: [x, late(p[0])], [0.2]),
        "wind, and lag": terms(y, lambda p: [lag(x, t, abs(p[0]) * 300), v], [0.2]),
    }
