"""How bright eleven samples glow at 532 nm under light of 392 nm over how bright they do under 398 nm, 20 minutes each while they react. Both colours make the same stuff glow."""

import numpy as np
from formats.rows import numbered
from models.bends import bends_with
from models.fitting import line, scaled, terms
from models.lags import in_runs, lag, moved
from readers.tensorly import glow

HAND_BUILT = "line"
SAMPLES = range(0, 64, 5)
OUTLIERS = (34, 35, 44, 45, 63)


def rows(content):
    samples = [one for one in SAMPLES if one not in OUTLIERS]
    first, second = glow(content, samples, 8, 5, 6)
    run = numbered(first)
    return {"run": run, "time_s": np.arange(len(run)) * 20, "under_398_nm": second.ravel(), "under_392_nm": first.ravel()}


def models(c):
    y, x, t, run = c["under_392_nm"], c["under_398_nm"], c["time_s"], c["run"]
    since_start = in_runs(run, t, lambda rows, s: s)
    late = lambda p: in_runs(run, t, lambda rows, s: lag(x[rows], s, (abs(p) + 0.01) * 20))
    later = lambda p: in_runs(run, t, lambda rows, s: moved(x[rows], s, p * 20))
    return y, {
        "as it is": lambda seen: x,
        **bends_with(y, x, drift=scaled(t), time=since_start / 1000),
        "first minutes": line(y, x, np.exp(-since_start / 200)),
        "shift": terms(y, lambda p: [later(p[0])], [0.5]),
        "lag": terms(y, lambda p: [late(p[0])], [0.5]),
    }
