"""Reflection of a ring-slot array against a full-wave simulation: a ripple over frequency is left, as of standing waves in the set-up."""

import numpy as np
from models.cycles import tone
from models.fitting import line, terms

HAND_BUILT = "ripple over frequency"


def touchstone(content, columns):
    """Frequency and size of the first scattering parameter."""
    lines = [line.split() for line in content.decode().splitlines() if line[:1].isdigit()]
    a = np.array([[float(v) for v in line] for line in lines if len(line) == columns])
    return a[:, 0], np.hypot(a[:, 1], a[:, 2])


def rows(measured, simulated):
    frequency, reflection = touchstone(measured, 3)
    return {"frequency_ghz": frequency, "simulated": np.interp(frequency, *touchstone(simulated, 9)), "reflection": reflection}


def models(c):
    y, x, frequency = c["reflection"], c["simulated"], c["frequency_ghz"]
    return y, {"line": line(y, x), HAND_BUILT: terms(y, lambda p: [x, *tone(frequency, p[0])], [7.0])}
