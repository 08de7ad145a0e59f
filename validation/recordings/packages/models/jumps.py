"""A zero or a slope that is another from some value or time on."""

import numpy as np
from models.fitting import line, scaled


def soft_step(x, at, width):
    """0 well below a value, 1 well above it."""
    return 0.5 + 0.5 * np.tanh((x - at) / (2 * width))


def switched_at(y, x, t, at):
    """What is tried where something was switched at a time: a step of the zero, of the slope, and of both, with a bend and a drift."""
    step, u, v = (t > at) * 1.0, scaled(x), scaled(t)
    return {
        "step": line(y, x, step),
        "slope from then on": line(y, x, x * step),
        "step, and slope": line(y, x, step, x * step),
        "step, and square": line(y, x, u**2, step),
        "step, and drift": line(y, x, step, v),
        "step, and drift after it": line(y, x, step, step * v, step * v**2),
    }


PLACES, FINER = np.arange(0.05, 0.951, 0.01), np.arange(-0.01, 0.0101, 0.0005)


def changed(y, t, beside, what):
    """A model whose zero, or a slope, is another from some time on: `what` gives the term `beside` the others, and the time is that at which the rows seen are fitted best."""
    model = lambda place: line(y, *beside, what * (t > t[0] + place * (t[-1] - t[0])))

    def predicted(seen):
        left = lambda place: np.std((y - model(place)(seen))[seen])
        about = min(PLACES, key=left)
        return model(min(about + FINER, key=left))(seen)

    return predicted
