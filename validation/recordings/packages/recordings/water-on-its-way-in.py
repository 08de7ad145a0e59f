"""A ship takes in water: how warm it is in the laboratory over how warm it was in the sea, beside its salt, twelve days from off Biscay to the equator."""

from durations import DAY
from models.cycles import tone
from models.drifts import usual_shifts_and_drifts
from models.drivers import of_drivers
from models.fitting import line, scaled, terms
from models.lags import behind
from readers.fluxengine import cruise

HAND_BUILT = "line"


def rows(content):
    return cruise(content, 0, 1500, sea_degc="temperature", salt="salinity", laboratory_degc="temperature_eq")


def models(c):
    y, x, t = c["laboratory_degc"], c["sea_degc"], c["time_s"]
    u = scaled(x)
    return y, {
        **usual_shifts_and_drifts(y, x, t, 600),
        **behind(y, x, t, 600),
        **of_drivers(y, x, salt=c["salt"]),
        "day": line(y, x, *tone(t, DAY)),
        "square, and day": line(y, x, u**2, *tone(t, DAY)),
        "corner": terms(y, lambda p: [x, (x > p[0]) * (x - p[0])], [float(x.mean())]),
    }
