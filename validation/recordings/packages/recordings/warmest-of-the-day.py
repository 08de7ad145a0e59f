"""The warmest of a day over the coldest of it on a farm, five years. The sun warms the day, and so does what comes with damp air."""

from durations import DAY
from models.cycles import tone
from models.drivers import of_drivers
from models.fitting import line, scaled, terms
from models.lags import lag, usual_and_shifts
from readers.pcse import farm_days

HAND_BUILT = "all squares of both"


def rows(*contents):
    return farm_days(*contents)


def models(c):
    y, x, t, sun, wet = (c[name] for name in ("warmest_degc", "coldest_degc", "time_s", "sun_mj_m2", "vapour_kpa"))
    u, v, w, year = scaled(x), scaled(sun), scaled(wet), tone(t, 365.2425 * DAY)
    return y, {
        **of_drivers(y, x, sun=sun, vapour=wet),
        **{name: model for name, model in usual_and_shifts(y, x, t, DAY).items() if name in ("drift", "shift", "lag")},
        "year": line(y, x, *year),
        "sun, and year": line(y, x, v, *year),
        "sun, and drift": line(y, x, v, t),
        "sun, and late warmth": terms(y, lambda p: [x, v, lag(x, t, abs(p[0]) * DAY)], [3.0]),
        "late sun": terms(y, lambda p: [x, lag(sun, t, abs(p[0]) * DAY)], [0.5]),
        "sun, and vapour": line(y, x, v, w),
        "sun, and slope by vapour": line(y, x, v, w, u * w),
        "slope by sun, and vapour": line(y, x, v, u * v, w),
        "slopes by both": line(y, x, v, u * v, w, u * w),
        "sun, vapour, and its square": line(y, x, v, w, w**2),
        "sun, vapour, and square": line(y, x, u**2, v, w),
        "sun, vapour, and year": line(y, x, v, w, *year),
        "all squares of both": line(y, x, u**2, v, w, v**2, w**2, u * v, u * w, v * w),
    }
