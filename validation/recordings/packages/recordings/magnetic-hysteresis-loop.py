"""Magnetic moment of a specimen over the field, down and up again: saturation, and a loop between the two ways.

Two models were built: one branch each way by a tanh, and a soft part (Langevin) with a hard one (tanh), each with a coercive field. The second is the one of the table.
"""

import numpy as np
from models.fitting import line, terms

HAND_BUILT = "Langevin and tanh, each with a coercive field"


def rows(content):
    lines = content.decode().splitlines()[1:]
    values = np.array([[float(v) for v in line.split(",")] for line in lines if line.strip() and line.count(",") == 1])
    return {"field": values[:, 0] / 1e4, "moment": values[:, 1] / 1e4}


def models(c):
    y, field = c["moment"], c["field"]
    way = np.r_[0, np.where(np.diff(field) > 0, 1.0, -1.0)]
    way[0] = way[1]

    def tanh(coercive, width):
        return np.tanh((field - way * coercive) / abs(width))

    def langevin(coercive, width):
        x = (field - way * coercive) / abs(width)
        x = np.where(np.abs(x) < 1e-4, 1e-4, x)
        return 1 / np.tanh(x) - 1 / x

    return y, {
        "line": line(y, field),
        "tanh, no loop": terms(y, lambda p: [field, np.tanh(field / abs(p[0]))], [0.2]),
        "tanh with a coercive field": terms(y, lambda p: [field, tanh(*p)], [0.03, 0.2]),
        HAND_BUILT: terms(y, lambda p: [field, langevin(*p[:2]), tanh(*p[2:])], [0.03, 0.05, 0.03, 0.3]),
    }
