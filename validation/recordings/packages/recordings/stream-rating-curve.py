"""Discharge of a stream over its stage: it was computed from the stage by a table, a power law."""

import io

import numpy as np
import pandas as pd
from models.fitting import line, terms

HAND_BUILT = "a (stage - h0)^b"


def rows(content):
    d = pd.read_parquet(io.BytesIO(content)).iloc[2::4, [1, 3]]
    first = pd.read_parquet(io.BytesIO(content)).index[0]
    return {"time_s": (d.index - first).total_seconds(), "stage_ft": d.iloc[:, 1], "discharge_cfs": d.iloc[:, 0]}


def models(c):
    y, stage = c["discharge_cfs"], c["stage_ft"]
    return y, {"line": line(y, stage), HAND_BUILT: terms(y, lambda p: [np.maximum(stage - p[0], 0) ** p[1]], [0.3, 1.8])}
