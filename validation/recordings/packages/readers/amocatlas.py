"""Reads files of the package amocatlas."""

import pandas as pd
from durations import DAY
from formats.netcdf import dataset, filled
from formats.rows import means


def overflow(content):
    """Water that flows over a sill in the sea in Sv, means of three days; a run lasts from one gap of more than five days to the next."""
    with dataset(content) as file:
        frame = pd.DataFrame({name: filled(file[name]).ravel() for name in ("TIME", "FBC_tr")}).dropna()
    seconds = (frame.TIME - frame.TIME.iloc[0]) * DAY
    numbers = (seconds.diff() > 5 * DAY).cumsum() + 1
    parts = [pd.DataFrame({"run": run, "time_s": means(seconds[rows], 3), "flow_sv": means(frame.FBC_tr[rows], 3).round(4)}) for run, rows in frame.groupby(numbers).groups.items()]
    return pd.concat(parts, ignore_index=True)
