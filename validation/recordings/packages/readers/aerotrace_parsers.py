"""Reads files of the package aerotrace-parsers."""

import numpy as np
import pandas as pd
from formats.text import csv


def engine(content, begin):
    """Rows of the monitor of an aircraft's engine from one on, by the names before the unit; seconds since the first, as many rows a second as the whole recording has."""
    lines = content.decode("latin1").splitlines()
    head = next(k for k, text in enumerate(lines) if text.startswith("TIME,"))
    frame = csv("\n".join(text.rstrip(",") for text in lines[head:]).encode(), index_col=False)
    when = pd.to_timedelta(frame.TIME)
    step = (when.iloc[-1] - when.iloc[0]).total_seconds() / (len(frame) - 1)
    frame.columns = [name.split(";")[0] for name in frame.columns]
    frame = frame.iloc[begin:]
    return frame.assign(time_s=(np.arange(len(frame)) * step).round(3))
