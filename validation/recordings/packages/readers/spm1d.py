"""Reads files of the package spm1d."""

import io

import numpy as np
import pandas as pd


def steps_on_treadmill(contents, speeds, between):
    """Troughs of the force under a foot between its two peaks, a run a walker, and the speed in m/s, a row a step."""
    speeds, parts = np.load(io.BytesIO(speeds), allow_pickle=False), []
    for run, content in enumerate(contents):
        forces = np.load(io.BytesIO(content), allow_pickle=False)
        parts.append(pd.DataFrame({"run": run + 1, "speed_m_s": speeds[:, run], "trough": forces[:, slice(*between)].min(axis=1)}))
    return pd.concat(parts, ignore_index=True)
