"""Strain across a specimen over the strain along it while it is pulled, each 0.03 s. Where it yields it keeps its volume."""

import pandas as pd
from formats.clock import since_first
from formats.text import csv
from models.bends import bends

HAND_BUILT = "line"


def rows(content):
    frame = csv(content, skipinitialspace=True).iloc[:, [0, 3, 4]].apply(pd.to_numeric, errors="coerce")
    frame.columns = ["time_s", "axial", "across"]
    frame = frame[frame.axial.cummax() == frame.axial].iloc[40:].dropna()
    return {"time_s": since_first(frame.time_s), "axial_ppm": frame.axial * 1e6, "across_ppm": frame.across * 1e6}


def models(c):
    return c["across_ppm"], bends(c["across_ppm"], c["axial_ppm"])
