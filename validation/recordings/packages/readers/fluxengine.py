"""Reads files of the package fluxengine, and holds models that its recordings share."""

from durations import DAY
from formats.clock import seconds
from formats.text import csv
from models.cycles import tone
from models.drifts import usual_shifts_and_drifts
from models.drivers import of_drivers
from models.fitting import line, scaled, terms
from models.lags import behind


def cruise(content, first, last, **names):
    """Columns of a cruise from one row to another; seconds since the first."""
    frame = csv(content, sep="\t", parse_dates=["datetime"]).iloc[first:last]
    return {"time_s": seconds(frame.datetime), **{name: frame[column].to_numpy() for name, column in names.items()}}


def water_models(c):
    """Models of how warm the water is in the laboratory over how warm it was in the sea, beside its salt."""
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
