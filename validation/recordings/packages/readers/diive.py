"""Reads files of the package diive."""

import numpy as np
import pandas as pd
from formats.clock import seconds
from formats.text import csv


def tower(content, *names):
    """Half hours of a tower above a field in which these columns have numbers, with seconds since the first."""
    frame = csv(content, low_memory=False)
    when = pd.to_datetime(frame.TIMESTAMP_END.astype(str), format="%Y%m%d%H%M", errors="coerce")
    frame = frame[list(names)].apply(pd.to_numeric, errors="coerce").replace(-9999, np.nan).assign(when=when).dropna()
    return frame.assign(time_s=seconds(frame.when))
