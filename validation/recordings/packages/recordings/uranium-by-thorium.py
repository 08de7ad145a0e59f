"""Counts of uranium over those of thorium while a laser drills into glass, a run a crater, three hours. The instrument drifts, and a part follows the depth of the crater."""

import numpy as np
from models.fitting import line, terms
from readers.lasertram import craters

HAND_BUILT = "slope by depth, and slope that drifts"


def rows(content):
    return craters(content, "GSD-1G", "232Th", "238U").rename(columns={"first_kcps": "thorium_kcps", "second_kcps": "uranium_kcps"})


def models(c):
    y, x, t, deep = c["uranium_kcps"], c["thorium_kcps"], c["time_s"] / 3600, c["drilled_s"]
    return y, {
        "line": line(y, x),
        "square": line(y, x, x**2),
        "drift": line(y, x, t),
        "drift, and its square": line(y, x, t, t**2),
        "slope that drifts": line(y, x, t, x * t),
        "depth": line(y, x, deep),
        "slope by depth": line(y, x, deep, x * deep),
        "slope by depth, bent": line(y, x, deep, x * deep, deep**2, x * deep**2),
        "slope by depth, and square": line(y, x, deep, x * deep, x**2),
        "slope by depth, and drift": line(y, x, deep, x * deep, t),
        "slope by depth, and slope that drifts": line(y, x, deep, x * deep, t, x * t),
        "slope by depth that fades": terms(y, lambda p: [x, x * np.exp(-deep / (abs(p[0]) * 5)), np.exp(-deep / (abs(p[0]) * 5))], [1.0]),
    }
