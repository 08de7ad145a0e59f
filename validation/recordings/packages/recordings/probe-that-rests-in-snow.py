"""What the force on the tip of a pole does while it rests in snow, from a tenth of a second after it came to a stop on; fewer counts are more force."""

import numpy as np
from formats.clock import since_first
from models.drifts import fades
from models.fitting import line, scaled, terms
from models.jumps import changed
from readers.study_lyte import push

HAND_BUILT = "logarithm from a time on"
STOPPED_S = 2.1


def rows(content):
    told = push(content, 10)
    told = told[told.time > STOPPED_S]
    return {"time_s": since_first(told.time), "force": told["Sensor1"]}


def models(c):
    y, t = c["force"], c["time_s"]
    w, late = scaled(t), np.log(t + 0.02)
    return y, {
        "constant": line(y),
        "drift": line(y, w),
        "drift, and its square": line(y, w, w**2),
        "drift, its square and cube": line(y, w, w**2, w**3),
        "logarithm": line(y, late),
        "logarithm from a time on": terms(y, lambda p: [np.log(t + abs(p[0]) * 0.1 + 1e-3)], [0.5]),
        "logarithm, and drift": line(y, late, w),
        "drift to a rest": terms(y, lambda p: [fades(t, p[0])], [0.3]),
        "drift to a rest, and drift": terms(y, lambda p: [fades(t, p[0]), w], [0.3]),
        "step": changed(y, t, [], 1.0),
        "logarithm, and step": changed(y, t, [late], 1.0),
    }
