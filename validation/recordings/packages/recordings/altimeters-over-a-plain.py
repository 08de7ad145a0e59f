"""Height of a plane over the ground by radar over that by laser, four lines over a plain. The laser sees a spot, the radar a patch that it flies over for seconds."""

import numpy as np
from models.bends import bends_with
from models.fitting import line, scaled, terms
from models.lags import lag, moved
from readers.galileoqc import means_along_runs, survey

HAND_BUILT = "mean of nine rows, shift, and drift"


def rows(content):
    return survey(content, laser_m="LALT", radar_m="RALT")


def models(c):
    y, x, t, run = c["radar_m"], c["laser_m"], c["time_s"], c["run"]
    w, wide = scaled(t), means_along_runs(x, run, 9)
    return y, {
        "as it is": lambda seen: x,
        "zero": lambda seen: x + np.mean((y - x)[seen]),
        **bends_with(y, x),
        "shift": terms(y, lambda p: [moved(x, t, p[0])], [0.2]),
        "lag": terms(y, lambda p: [lag(x, t, abs(p[0]))], [0.4]),
        "drift": line(y, x, w),
        "zero of each run": line(y, x, *(run == k for k in np.unique(run)[1:])),
        **{f"mean of {name} rows": line(y, means_along_runs(x, run, rows)) for name, rows in (("three", 3), ("five", 5), ("seven", 7), ("nine", 9), ("eleven", 11))},
        "line, and mean of nine rows": line(y, x, wide),
        "mean of nine rows, and square": line(y, wide, scaled(wide) ** 2),
        "mean of nine rows, and drift": line(y, wide, w),
        "mean of nine rows, and zero of each run": line(y, wide, *(run == k for k in np.unique(run)[1:])),
        "mean of nine rows, and shift": terms(y, lambda p: [moved(wide, t, p[0])], [0.2]),
        "mean of nine rows, shift, and drift": terms(y, lambda p: [moved(wide, t, p[0]), w], [0.2]),
    }
