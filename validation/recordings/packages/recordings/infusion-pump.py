"""Remifentanil in the blood of 65 people while a pump gives it and after: it follows the rate late, quickly at first; heavy people dilute it more.

Rows with an assay; the rate of a row is that of the pump until the next one. A run begins with the first assay, when the pump has been on for a minute or so.
"""

import numpy as np
from models.fitting import line, terms
from readers.rdatasets import frame

HAND_BUILT = "two lags"


def rows(content):
    d = frame(content).astype({"Time": float, "conc": float, "Rate": float, "Wt": float, "Subject": int})
    d = d.sort_values(["Subject", "Time"], kind="stable").dropna(subset=["conc"]).drop_duplicates(["Subject", "Time"])
    return {"subject": d.Subject, "time_s": d.Time * 60, "rate_ug_min": d.Rate, "weight_kg": d.Wt, "concentration": d.conc}


def followed(rate, t, subject, tau):
    """First-order lag of a rate that keeps its value until the next row, from zero a minute and a half before the first row of each run."""
    out = np.empty(len(rate))
    for i in range(len(rate)):
        begins = i == 0 or subject[i] != subject[i - 1]
        before, held, step = (0.0, rate[i], 90.0) if begins else (out[i - 1], rate[i - 1], t[i] - t[i - 1])
        out[i] = held + (before - held) * np.exp(-step / max(tau, 1e-9))
    return out


def models(c):
    y, t, rate, weight, subject = c["concentration"], c["time_s"], c["rate_ug_min"], c["weight_kg"], c["subject"]

    def one(p):
        slow = followed(rate, t, subject, abs(p[0]))
        return [slow, slow * (weight - 70)]

    def two(p):
        quick, slow = followed(rate, t, subject, abs(p[0])), followed(rate, t, subject, abs(p[1]))
        return [quick, slow, quick * (weight - 70)]

    lag = terms(y, lambda p: [followed(rate, t, subject, abs(p[0]))], [300.0])
    return y, {"line": line(y, rate), "one lag": lag, "and weight": terms(y, one, [300.0]), HAND_BUILT: terms(y, two, [100.0, 900.0])}
