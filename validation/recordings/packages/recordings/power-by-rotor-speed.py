"""Power of a wind turbine over the speed of its generator, ten minutes. Above a speed it rises more steeply, and it comes after the speed."""

import numpy as np
from models.fitting import line, scaled, terms
from models.lags import lag, moved, usual
from readers.wetb import turbine_sensors

HAND_BUILT = "bend of a lag, and drift"


def rows(content):
    read = turbine_sensors(content)
    return {"time_s": read["time_s"], "speed_rpm": read["Gen_RPM"], "power_kw": read["Power"]}


def models(c):
    y, x, t = c["power_kw"], c["speed_rpm"], c["time_s"]
    u = scaled(x)
    bend = lambda u, at, soft: np.logaddexp(0, (u - at) / (abs(soft) + 0.01))
    late = lambda p: lag(u, t, abs(p[0]) * 10)
    return y, {
        **usual(y, x, t, 5),
        "cube": line(y, u, u**2, u**3),
        "bend": terms(y, lambda p: [u, bend(u, *p)], [0.3, 0.2]),
        "square, and lag": terms(y, lambda p: [u, u**2, late(p)], [0.5]),
        "cube, and lag": terms(y, lambda p: [u, u**2, u**3, late(p)], [0.5]),
        "bend, and lag": terms(y, lambda p: [u, bend(u, *p[:2]), late(p[2:])], [0.3, 0.2, 0.5]),
        "bend, shifted": terms(y, lambda p: [s := moved(u, t, p[2] * 3), bend(s, *p[:2])], [0.3, 0.2, 0.3]),
        "bend of a lag": terms(y, lambda p: [s := late(p[2:]), bend(s, *p[:2])], [0.3, 0.2, 0.1]),
        "bend of a lag, and drift": terms(y, lambda p: [s := late(p[2:]), bend(s, *p[:2]), t], [0.3, 0.2, 0.1]),
        "bend of a lag of a lag": terms(y, lambda p: [s := lag(late(p[2:]), t, abs(p[2]) * 10), bend(s, *p[:2])], [0.3, 0.2, 0.1]),
        "bend, and drift": terms(y, lambda p: [u, bend(u, *p), t], [0.3, 0.2]),
    }
