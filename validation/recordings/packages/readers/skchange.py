"""Reads files of the package skchange."""

import numpy as np
from durations import DAY
from formats.clock import seconds
from formats.text import csv
from models.cycles import tone
from models.drifts import fades
from models.fitting import line, scaled, terms


def fan(content, unit, low=0.0, high=np.inf):
    """How a fan of a building shakes, a row each ten minutes, rows between two values; seconds since the first."""
    frame = csv(content, parse_dates=["time"])
    frame = frame[(frame.unit_id == unit) & (frame.vibration > low) & (frame.vibration < high)]
    return {"time_s": seconds(frame.time), "shaking": frame.vibration.to_numpy()}


def fan_models(c):
    """Models of what a fan does by the day: waves, a drift, a week and a step."""
    y, t = c["shaking"], c["time_s"]
    w, waves = scaled(t), {n: [part for k in range(1, n + 1) for part in tone(t, DAY / k)] for n in (1, 2, 3, 5, 8)}
    week, late = tone(t, 7 * DAY), (t > t[-1] / 2) * 1.0
    return y, {
        "constant": line(y),
        "drift": line(y, w),
        "drift, and its square": line(y, w, w**2),
        "drift to a rest": terms(y, lambda p: [fades(t, p[0])], [0.3]),
        "step in the middle": line(y, late),
        "week": line(y, *week),
        "one wave a day": line(y, *waves[1]),
        "two waves a day": line(y, *waves[2]),
        "three waves a day": line(y, *waves[3]),
        "five waves a day": line(y, *waves[5]),
        "eight waves a day": line(y, *waves[8]),
        "two waves a day, and drift": line(y, w, *waves[2]),
        "three waves a day, and drift": line(y, w, *waves[3]),
        "three waves a day, and week": line(y, *week, *waves[3]),
    }
