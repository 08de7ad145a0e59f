"""Stress in a soap with a polymer over its shear rate, in a rheometer at six temperatures and at the first again, one a run: it thins as it is sheared, and is thinner where it is warmer."""

import numpy as np
from formats.text import csv
from models.fitting import curve, line

HAND_BUILT = "thinning, by temperature"


def rows(content):
    d = csv(content).sort_values("sample_id", key=lambda ids: ids.map(ORDER), kind="stable")
    warm = d.sample_id.str.extract(r"T_(\d+)")[0].astype(int)
    return {"run": d.sample_id.map(ORDER), "temperature_c": warm.astype(float), "rate_per_s": d["shear_rate_1/s"], "stress_pa": d.stress_Pa}


ORDER = {"T_18": 1, "T_20": 2, "T_22": 3, "T_24": 4, "T_26": 5, "T_28": 6, "T_18_repeat": 7}


def models(c):
    y, x, warm = c["stress_pa"], c["rate_per_s"], c["temperature_c"] - 23

    def carreau(p, of):
        return p[0] * np.exp(-p[1] * of) * x / (1 + (x * np.exp(p[2] - p[3] * of)) ** 2) ** p[4]

    return y, {
        "line": line(y, x),
        "root": line(y, np.sqrt(x), x),
        "thinning": curve(y, lambda p: carreau([p[0], 0, p[1], 0, p[2]], warm), [8.0, -2.0, 0.4]),
        HAND_BUILT: curve(y, lambda p: carreau(p, warm), [8.0, 0.1, -2.0, 0.1, 0.4]),
        "two thinning parts, each by temperature": curve(y, lambda p: carreau(p[:5], warm) + carreau([p[5], p[6], p[7], p[8], 0.1], warm), [8.0, 0.1, -2.0, 0.1, 0.5, 1.0, 0.05, -2.0, 0.1]),
    }
