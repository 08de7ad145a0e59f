"""The sun by a solar cell for its middle colours over that by one for its blue ones, each minute of a day with clouds. The lower it stands, the redder it is."""

from durations import DAY
from models.cycles import tone
from models.drivers import of_drivers
from models.fitting import line, scaled
from models.lags import usual_and_shifts
from readers.cpvlib import sunny_station

HAND_BUILT = "all squares of height"


def rows(content):
    return sunny_station(content, 5, height_deg="Elev.Sol", blue_w_m2="Celula Top", middle_w_m2="Celula Mid")


def models(c):
    y, x, t, high = c["middle_w_m2"], c["blue_w_m2"], c["time_s"], c["height_deg"]
    u, v, w = scaled(x), scaled(high), scaled(t)
    return y, {
        **of_drivers(y, x, height=high),
        **{name: model for name, model in usual_and_shifts(y, x, t, 60).items() if name in ("drift", "shift", "lag")},
        "day": line(y, x, *tone(t, DAY)),
        "slope by height and its square": line(y, x, v, u * v, u * v**2),
        "slope by height, and drift": line(y, x, v, u * v, w),
        "slope by height, and slope that drifts": line(y, x, v, u * v, w, u * w),
        "slope that drifts": line(y, x, w, u * w),
    }
