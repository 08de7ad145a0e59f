"""Frequency of a superconducting resonator over its temperature, at three powers, a day with a pause of twenty hours. What is around it stiffens, then its electrons slow it."""

import numpy as np
from models.fitting import line, scaled, terms
from models.lags import usual
from readers.scraps import resonance, traces
from scipy.special import digamma

HAND_BUILT = "two-level systems, and electrons"
QUANTUM_K = 4.7992e-11 * 8.175e9  # the energy of a quantum of this frequency, as a temperature


def rows(content):
    found = [(when, warm, resonance(hertz, passed)) for when, _, warm, hertz, passed in traces(content, 1, (-10, -20, -30))]
    when, warm, hertz = np.array(found).T
    return {"time_s": when, "cold_k": warm, "resonance_khz": (hertz - hertz[0]) / 1000}


def models(c):
    y, warm, t = c["resonance_khz"], c["cold_k"], c["time_s"]
    systems = np.real(digamma(0.5 + QUANTUM_K / (2j * np.pi * warm))) - np.log(QUANTUM_K / (2 * np.pi * warm))
    electrons = lambda p: np.exp(-abs(p) / warm)
    u = scaled(warm)
    return y, {
        **usual(y, warm, t, 600),
        "cube": line(y, u, u**2, u**3),
        "fifth power": line(y, u, u**2, u**3, u**4, u**5),
        "two-level systems": line(y, systems),
        "two-level systems, and electrons": terms(y, lambda p: [systems, electrons(p[0])], [15.0]),
        "both, and drift": terms(y, lambda p: [systems, electrons(p[0]), t], [15.0]),
    }
