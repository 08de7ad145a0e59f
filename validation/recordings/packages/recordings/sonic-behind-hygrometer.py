"""Temperature by sound over the water vapour beside it, above a field by day, 20 readings a second, five minutes. What rises is warm and moist; the anemometer gives its numbers a tenth of a second later."""

import numpy as np
from models.fitting import terms
from models.lags import lag, usual
from readers.fluxpart import eddy_station

HAND_BUILT = "shift"


def rows(content):
    frame = eddy_station(content)
    return {"time_s": frame.time_s, "vapour_g_m3": frame.h2o, "sonic_c": frame.Ts}


def models(c):
    y, x, t = c["sonic_c"], c["vapour_g_m3"], c["time_s"]
    shifted = lambda p: np.interp(t - p * 0.1, t, x)
    return y, {
        **usual(y, x, t, 0.1),
        "shift, and drift": terms(y, lambda p: [shifted(p[0]), t], [1.0]),
        "shift and lag": terms(y, lambda p: [lag(shifted(p[0]), t, abs(p[1]) * 0.1)], [1.0, 1.0]),
    }
