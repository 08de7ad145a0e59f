"""Force of a thigh that pushes and holds and lets go, 32 s, over how loud 64 electrodes on it are. A muscle is loud before it pulls."""

import numpy as np
from models.fitting import line, terms
from models.lags import lag, moved, usual_and_lags
from readers.openhdemg import muscle

HAND_BUILT = "lag that is shifted, and drift"


def rows(content):
    return muscle(content, electrodes=64, hertz=2048, every=256)


def models(c):
    y, x, t = c["force_pct"], c["loud_uv"] / 100, c["time_s"]
    late = lambda p: lag(x, t, abs(p))
    return y, {
        **usual_and_lags(y, x, t, 0.5),
        "cube": line(y, x, x**2, x**3),
        "root": line(y, np.sqrt(x)),
        "lag that is shifted": terms(y, lambda p: [moved(late(p[0]), t, p[1])], [0.3, 0.05]),
        "lag that is shifted, and drift": terms(y, lambda p: [moved(late(p[0]), t, p[1]), t], [0.3, 0.05]),
        "lag, drift, and its square": terms(y, lambda p: [late(p[0]), t, t**2], [0.3]),
        "lag, and slope that drifts": terms(y, lambda p: [late(p[0]), t * late(p[0])], [0.3]),
        "root of the lag": terms(y, lambda p: [np.sqrt(late(p[0]))], [0.3]),
        "saturation of the lag": terms(y, lambda p: [np.tanh(late(p[0]) / abs(p[1]))], [0.3, 2.0]),
    }
