"""Fuel that the right engine of a jet burns over what the left one does, in flight. The pilots keep them alike."""

from models.fitting import line, scaled
from models.lags import usual_and_shifts
from readers.openap import flight

HAND_BUILT = "line"


def rows(content):
    return flight(content, 60, 3, {"left_kg_h": 3600, "right_kg_h": 3600}, left_kg_h="ff_l", right_kg_h="ff_r")


def models(c):
    y, x, t = c["right_kg_h"], c["left_kg_h"], c["time_s"]
    u, w = scaled(x), scaled(t)
    return y, {
        **usual_and_shifts(y, x, t, 3),
        "cube": line(y, x, u**2, u**3),
        "drift, and its square": line(y, x, w, w**2),
        "slope that drifts": line(y, x, u * w),
        "drift, and slope that drifts": line(y, x, w, u * w),
        "square, and drift": line(y, x, u**2, w),
    }
