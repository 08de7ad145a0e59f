"""Reads files of the package spm1d."""

import pandas as pd
from formats.arrays import array


def steps_on_treadmill(contents, speeds, between):
    """Troughs of the force under a foot between its two peaks, a run a walker, and the speed in m/s, a row a step."""
    speeds, parts = array(speeds), []
    for run, content in enumerate(contents):
        forces = array(content)
        parts.append(pd.DataFrame({"run": run + 1, "speed_m_s": speeds[:, run], "trough": forces[:, slice(*between)].min(axis=1)}))
    return pd.concat(parts, ignore_index=True)
