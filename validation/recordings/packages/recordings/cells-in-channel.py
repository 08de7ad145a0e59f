"""Place of cells across the channel in which they pass a camera, two and a half minutes. They keep to one line, which hardly moves."""

import numpy as np
from models.fitting import line, terms
from models.jumps import soft_step
from readers.dclab import cells

HAND_BUILT = "drift, and its square"


def rows(content):
    frame = cells(content, "pos_y")
    return {"time_s": frame.time_s, "across_um": frame.pos_y}


def models(c):
    y, t = c["across_um"], c["time_s"]
    step = lambda p: soft_step(t, p * 100, 1)
    return y, {
        "constant": line(y),
        "drift": line(y, t),
        "drift, and its square": line(y, t, t**2),
        "drift that fades": terms(y, lambda p: [np.exp(-t / (abs(p[0]) * 50 + 1))], [0.5]),
        "step": terms(y, lambda p: [step(p[0])], [0.7]),
        "two steps": terms(y, lambda p: [step(p[0]), step(p[1])], [0.4, 1.0]),
    }
