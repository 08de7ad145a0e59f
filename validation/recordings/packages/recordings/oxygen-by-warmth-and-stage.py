"""Oxygen in a spring run over how warm it is, 17 months of days, and its stage. When the river below is high it holds back the run."""

from durations import DAY
from models.cycles import tone
from models.drivers import of_drivers
from models.fitting import line
from readers.hydrotoolbox import spring

HAND_BUILT = "square, stage, and year"


def rows(content):
    return spring(content, "water_degc", "stage_m", "oxygen_mg_l")


def models(c):
    y, x, stage, t = c["oxygen_mg_l"], c["water_degc"], c["stage_m"], c["time_s"]
    return y, {
        **of_drivers(y, x, stage=stage),
        "stage, and drift": line(y, x, stage, t),
        "square, stage, and drift": line(y, x, x**2, stage, t),
        "year": line(y, x, *tone(t, 365.25 * DAY)),
        "stage, and year": line(y, x, stage, *tone(t, 365.25 * DAY)),
        "square, stage, and year": line(y, x, x**2, stage, *tone(t, 365.25 * DAY)),
    }
