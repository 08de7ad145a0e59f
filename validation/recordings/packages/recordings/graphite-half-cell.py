"""Voltage of a graphite half cell, charged and discharged by a steady current: a curve over charge, and polarisation with the sign of the current."""

import io

import numpy as np
import pandas as pd
from models.fitting import line, terms

HAND_BUILT = "free curve of 14 knots, polarisation"
KNOTS = np.array([0, 0.01, 0.02, 0.04, 0.07, 0.1, 0.15, 0.2, 0.3, 0.4, 0.5, 0.6, 0.8, 1.0])


def rows(content):
    d = pd.read_excel(io.BytesIO(content), sheet_name="Channel_11_1")
    d = d[d["Test_Time(s)"].diff().fillna(1) > 0]
    d = d.assign(q=(d["Discharge_Capacity(Ah)"] - d["Charge_Capacity(Ah)"]) * 1e3, i=d["Current(A)"] * 1e6)
    d = d.iloc[np.flatnonzero((d.i > 0).to_numpy())[0] :]
    d = d[d.i.abs() > 1]
    d = d.assign(t=(d["Test_Time(s)"] - d["Test_Time(s)"].iloc[0]).round(2))
    d = d[d.t.diff().fillna(1) > 0]
    return {"time_s": d.t, "charge_mah": d.q, "current_ua": d.i, "voltage_v": d["Voltage(V)"]}


def models(c):
    y, charge, sign = c["voltage_v"], c["charge_mah"], np.sign(c["current_ua"])
    x = (charge - charge.min()) / np.ptp(charge)
    hats = [np.interp(x, KNOTS, hat) for hat in np.eye(len(KNOTS))[1:]]
    decay = terms(y, lambda p: [charge, sign, np.exp(-x / (0.005 + abs(p[0])))], [0.02])
    return y, {"line": line(y, charge), "one exponential, polarisation": decay, HAND_BUILT: line(y, *hats, sign)}
