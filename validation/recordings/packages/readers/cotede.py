"""Reads files of the package cotede."""

import numpy as np
import pandas as pd
from formats.arrays import array


def ctd_cast(content, rows=None):
    """The rows of a lowering of a CTD, by time: those with numbers in all of the first ten columns."""
    with array(content) as file:
        frame = pd.DataFrame(file["data"].T, columns=list(file["varnames"]))
    frame = frame[(np.abs(frame.iloc[:, :10]) < 1e4).all(axis=1)]
    return frame[frame["timeS"].diff().fillna(1) > 0].iloc[:rows]
