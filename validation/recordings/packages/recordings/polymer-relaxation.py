"""Relaxation of a polymer at 21 temperatures: time and temperature exchange, so that one S over shifted log time holds for all."""

import numpy as np
from formats.text import csv
from models.fitting import curve, line

HAND_BUILT = "an S over log time, shifted by temperature"


def rows(content):
    d = csv(content, skiprows=[1])
    d = d.assign(run=d.Set + 1).sort_values(["run", "t"])
    return {"run": d.run, "time_s": d.t, "temperature_c": d["T"], "modulus_mpa": d.E_relax}


def models(c):
    y, warm, log_time = c["modulus_mpa"], c["temperature_c"], np.log10(c["time_s"])

    def shifted(p):
        return p[0] / (1 + np.exp(np.clip(p[1] * (log_time + p[3] * (warm - p[2])), -50, 50))) + p[4]

    return y, {"line": line(y, warm), HAND_BUILT: curve(y, shifted, [8500.0, 0.4, 20.0, 0.1, 100.0])}
