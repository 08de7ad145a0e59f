"""Voltage of a cell of an electric car over its current, pulses at ten states of charge, 25 degC, a row each 8 s or where the current changes. It has less voltage the emptier it is, and is late. The charge is the current summed up from the start."""

import numpy as np
from formats.rows import charged
from models.fitting import line, terms
from models.lags import lag, usual
from readers.celljar import cycler

HAND_BUILT = "charge, cubic, and late current"


def rows(content):
    frame = cycler(content)
    amp, t = frame.ampere.to_numpy(), frame.time_s.to_numpy()
    charge = charged(amp, t)
    kept = [int(np.argmax(t > 15400))]
    for k in range(kept[0] + 1, len(t)):
        if t[k] - t[kept[-1]] >= 8 or abs(amp[k] - amp[kept[-1]]) > 1:
            kept.append(k)
    return {"time_s": t[kept] - t[kept[0]], "current_a": amp[kept], "charge_ah": charge[kept], "voltage_v": frame.volt.to_numpy()[kept]}


def models(c):
    y, x, t, charge = c["voltage_v"], c["current_a"], c["time_s"], c["charge_ah"]
    late = lambda p: lag(x, t, abs(p) * 60)
    return y, {
        **usual(y, x, t),
        "charge": line(y, x, charge),
        "charge, bent": line(y, x, charge, charge**2),
        "charge, cubic": line(y, x, charge, charge**2, charge**3),
        "charge, bent, and late current": terms(y, lambda p: [x, late(p[0]), charge, charge**2], [1.0]),
        HAND_BUILT: terms(y, lambda p: [x, late(p[0]), charge, charge**2, charge**3], [1.0]),
    }
