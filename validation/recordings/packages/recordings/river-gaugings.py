"""Flow of a river as it was gauged by current meters and acoustic profilers, over its stage, 125 gaugings in twelve years. Deeper water is wider and faster."""

import numpy as np
import pandas as pd
from formats.clock import seconds
from formats.text import csv
from models.fitting import curve, line

HAND_BUILT = "power of the depth"


def rows(content):
    frame = csv(content)
    frame = frame.assign(when=pd.to_datetime(frame.datetime)).sort_values("when").drop_duplicates("when")
    return {"time_s": seconds(frame.when), "stage_m": frame.stage, "flow_m3_s": frame.q}


def models(c):
    y, x, t = c["flow_m3_s"], c["stage_m"], c["time_s"]
    return y, {
        "line": line(y, x),
        "square": line(y, x, x**2),
        "drift": line(y, x, t),
        "cubic": line(y, x, x**2, x**3),
        "square, and drift": line(y, x, x**2, t),
        "square, and gain that drifts": line(y, x, x**2, t, t * x),
        HAND_BUILT: curve(y, lambda p: p[0] * np.maximum(x - p[1], 1e-3) ** p[2], [100.0, 0.0, 1.5]),
    }
