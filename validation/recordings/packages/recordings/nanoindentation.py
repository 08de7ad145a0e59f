"""Depth of a nanoindenter over load: it keeps the greatest load so far (plastic), springs back by a power law (Oliver and Pharr), and drifts."""

import io

import numpy as np
import pandas as pd
from models.fitting import line, terms

HAND_BUILT = "greatest load so far, spring-back by a power of load over it, drift"


def rows(content):
    sheet = pd.read_excel(io.BytesIO(content), sheet_name="Test 002")
    sheet.columns = ["segment", "h", "load", "t", "stiffness", "hardness", "modulus"]
    d = sheet.iloc[1:][["t", "load", "h"]].apply(pd.to_numeric, errors="coerce").dropna()
    d = d[d.t.diff().fillna(1) > 0]
    peak = int(d.load.to_numpy().argmax())
    touch = np.flatnonzero((d.h.to_numpy() <= 0)[:peak])[-1] + 1
    d = d.iloc[touch:].reset_index(drop=True)
    d["t"] = (d.t - d.t[0]).round(3)
    d = d[d.t.diff().fillna(1) > 0].reset_index(drop=True)
    d = d.iloc[: np.flatnonzero(d.load.to_numpy() > 0.5)[-1] + 1]
    return {"time_s": d.t, "load_mn": d.load, "displacement_nm": d.h}


def models(c):
    y, t, load = c["displacement_nm"], c["time_s"], c["load_mn"].clip(0)
    most = np.maximum.accumulate(load)

    def power(x, exponent):
        return np.maximum(x, 1e-9) ** np.clip(exponent, 0.2, 3)

    def indented(p):
        return [np.sqrt(most), np.sqrt(most) * power(load / np.maximum(most, 1e-6), p[0]), t]

    return y, {"line": line(y, load), "root of the load": line(y, np.sqrt(load)), HAND_BUILT: terms(y, indented, [0.7])}
