"""Reads files of the package amocatlas."""

import numpy as np
import pandas as pd
from durations import DAY
from formats.rows import means


def overflow(content):
    """Water that flows over a sill in the sea in Sv, means of three days; a run lasts from one gap of more than five days to the next."""
    import netCDF4  # the other readers do without it

    with netCDF4.Dataset("memory", memory=content) as file:
        frame = pd.DataFrame({name: np.ma.filled(file[name][:].astype(float), np.nan).ravel() for name in ("TIME", "FBC_tr")}).dropna()
    seconds = (frame.TIME - frame.TIME.iloc[0]) * DAY
    numbers = (seconds.diff() > 5 * DAY).cumsum() + 1
    parts = [pd.DataFrame({"run": run, "time_s": means(seconds[rows], 3), "flow_sv": means(frame.FBC_tr[rows], 3).round(4)}) for run, rows in frame.groupby(numbers).groups.items()]
    return pd.concat(parts, ignore_index=True)
