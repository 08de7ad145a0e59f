"""Reads files of the package phytorch-lib."""

import pandas as pd
from formats.clock import since_first
from formats.rows import means
from formats.text import csv


def porometer(content, *names):
    """Readings of a porometer with a lamp for fluorescence: seconds since the first, and columns by their name."""
    frame = csv(content, skiprows=[0, 2])
    numbers = frame[list(names)].apply(pd.to_numeric)
    return numbers.assign(time_s=since_first(pd.to_timedelta(frame.Time).dt.total_seconds()))


def gas_exchange(content, every=5):
    """Curves of a leaf in a chamber, a run a curve, means of some readings: carbon dioxide inside of the leaf in ppm, light, and what the leaf takes up."""
    frame, parts = csv(content), []
    for run, curve in frame.groupby("CurveID"):
        told = {name: means(curve[column].to_numpy(), every) for name, column in (("inside_ppm", "Ci"), ("light_umol", "Qin"), ("uptake_umol", "A"))}
        parts.append(pd.DataFrame({"run": run, **told}))
    return pd.concat(parts, ignore_index=True)
