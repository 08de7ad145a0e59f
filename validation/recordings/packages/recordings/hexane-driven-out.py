"""How much hexane a zeolite holds over how warm it is, as it is heated by a degree a minute on a balance. It leaves in two steps."""

import numpy as np
from models.bends import bends_with, levels_off
from models.fitting import line, scaled, terms
from readers.datalabicb import sorption

HAND_BUILT = "two steps"


def rows(content):
    return dict(zip(("warmth_degc", "taken_up"), sorption(content, 967, ("Tdes / °C", "mades / (g.g-1)"))))


def models(c):
    y, x = c["taken_up"], c["warmth_degc"]
    u, step = scaled(x), lambda at, width: 1 / (1 + np.exp((x - at) / width))
    return y, {
        **bends_with(y, x),
        "fourth power": line(y, x, u**2, u**3, u**4),
        **levels_off(y, x, 200.0),
        "step": terms(y, lambda p: [step(*p)], [150.0, 40.0]),
        "step, and line": terms(y, lambda p: [x, step(*p)], [150.0, 40.0]),
        "two steps": terms(y, lambda p: [step(*p[:2]), step(*p[2:])], [110.0, 10.0, 190.0, 25.0]),
        "two steps, and line": terms(y, lambda p: [x, step(*p[:2]), step(*p[2:])], [110.0, 10.0, 190.0, 25.0]),
    }
