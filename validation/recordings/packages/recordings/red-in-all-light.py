"""Counts of red light over those of all light in a sensor of colours, three and a half days at a window."""

from durations import DAY
from models.cycles import tone
from models.drifts import usual_shifts_and_drifts
from models.fitting import line, scaled
from readers.sp00kyvectors import sensor_box

HAND_BUILT = "square"


def rows(content):
    return sensor_box(content, "2025-05-0[6-9]", least=("Color_C", 20), clear="Color_C", red="Color_R")


def models(c):
    y, x, t = c["red"], c["clear"], c["time_s"]
    u = scaled(x)
    return y, {
        **usual_shifts_and_drifts(y, x, t, 600),
        "fourth power": line(y, x, u**2, u**3, u**4),
        "day": line(y, x, *tone(t, DAY)),
        "square, and day": line(y, x, u**2, *tone(t, DAY)),
        "square, and slope that drifts": line(y, x, u**2, scaled(t), u * scaled(t)),
    }
