"""Thermocouple at the sample of a thermobalance beside that of its furnace, heated at 10 K/min, every eighth reading. The sample is behind while heat goes by gas, and hardly behind when it shines."""

import numpy as np
from models.fitting import terms
from models.lags import lag, usual
from readers.pyngb import thermal_analysis

HAND_BUILT = "lag that falls with radiation"


def rows(content):
    frame = thermal_analysis(content).iloc[::8]
    return {"time_s": frame.minutes * 60, "furnace_c": frame.furnace_c, "sample_c": frame.sample_c}


def warmed(p, x, t):
    """A body that follows by conduction and by radiation."""
    out = np.empty(len(x))
    out[0] = x[0]
    for k in range(1, len(x)):
        rate = (abs(p[0]) + abs(p[1]) * ((out[k - 1] + 273) / 800) ** 3) / 100
        keep = np.exp(-(t[k] - t[k - 1]) * rate)
        out[k] = keep * out[k - 1] + (1 - keep) * (x[k] + x[k - 1]) / 2
    return out


def models(c):
    y, x, t = c["sample_c"], c["furnace_c"], c["time_s"]
    return y, {
        **usual(y, x, t),
        "lag, square": terms(y, lambda p: [lag(x, t, abs(p[0]) * 60), lag(x, t, abs(p[0]) * 60) ** 2], [1.0]),
        HAND_BUILT: terms(y, lambda p: [warmed(p, x, t)], [1.0, 1.0]),
    }
