"""Reads files of the package cdt."""

import numpy as np
from formats.text import csv


def pair_columns(content, step=None, rows=None, **names):
    """Columns of pairs that lie in one table, a pair a row: each is told by the name of the pair and a letter; seconds since the first where a step is told."""
    frame = csv(content).set_index("SampleID")
    told = {name: np.array(frame.loc[pair, letter].split(), float)[:rows] for name, (pair, letter) in names.items()}
    clock = {} if step is None else {"time_s": np.arange(len(next(iter(told.values())))) * step}
    return {**clock, **told}
