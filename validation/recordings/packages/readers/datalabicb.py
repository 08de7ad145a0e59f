"""Reads files of the package datalabicb."""

import gzip
import json

import numpy as np
import pandas as pd


def sorption(content, number, *pairs):
    """Branches of one measurement of what a solid takes up, one after another: pairs of columns, rows without the zeros that fill them up. The end of a column's name may have a blank."""
    frame = pd.DataFrame(json.loads(gzip.decompress(content))[number]["data"]).rename(columns=str.strip)
    rows = np.concatenate([frame[list(pair)].to_numpy(float) for pair in pairs])
    return rows[rows[:, 0] > 0].T
