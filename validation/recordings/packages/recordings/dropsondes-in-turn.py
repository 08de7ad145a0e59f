"""Temperature of a dropsonde over that of another at the same pressure, which left the same aircraft two minutes before. They agree but for the weather between."""

import numpy as np
from models.lags import usual
from readers.pydropsonde import fall

HAND_BUILT = "shift"


def rows(first, second):
    before, frame = fall(first).sort_values("hpa"), fall(second)
    return {"time_s": frame.time_s, "first_c": np.interp(frame.hpa, before.hpa, before.degc), "second_c": frame.degc}


def models(c):
    y, x, t = c["second_c"], c["first_c"], c["time_s"]
    return y, usual(y, x, t, 5)
