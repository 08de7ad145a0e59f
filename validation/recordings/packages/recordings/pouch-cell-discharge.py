"""Voltage of a pouch cell over the charge that was taken from it, three discharges at three currents, each of some 600 rows. Charge and current are over the cell's capacity."""

import numpy as np
from formats.text import matrix
from models.fitting import line, terms

HAND_BUILT = "fifth power, current, and product"


def rows(*contents):
    parts = []
    for run, (content, current) in enumerate(zip(contents, (0.5, 1.0, 2.0)), 1):
        read = matrix(content)[3:]
        read = read[:: max(1, len(read) // 600)]
        parts.append(np.column_stack([np.full(len(read), run), read[:, 0] - read[0, 0], read[:, 0] * current / 3600, np.full(len(read), current), read[:, 1]]))
    whole = np.vstack(parts)
    return {"run": whole[:, 0].astype(int), **dict(zip(("time_s", "charge_h", "current_per_h", "volt"), whole[:, 1:].T))}


def models(c):
    y, q, current = c["volt"], c["charge_h"], c["current_per_h"]
    powers = lambda n: [q**k for k in range(1, n + 1)]
    return y, {
        "line": line(y, q),
        "current": line(y, q, current),
        "cubic": line(y, *powers(3)),
        "cubic, and current": line(y, *powers(3), current),
        "fifth power, and current": line(y, *powers(5), current),
        HAND_BUILT: line(y, *powers(5), current, current * q),
        "exponential, and current": terms(y, lambda p: [q, current, np.exp((q - 1) / abs(p[0]))], [0.05]),
    }
