"""Reads files of the package dclab."""

import pandas as pd
from formats.netcdf import dataset, filled


def cells(content, *names):
    """Cells that pass a camera, one by one, by the names of what it saw; seconds since the first, 2000 pictures a second; of those in one picture the first."""
    with dataset(content) as file:
        frame = pd.DataFrame({name: filled(file["events"][name]) for name in ("frame", *names)})
    frame = frame.drop_duplicates("frame")
    return frame.assign(time_s=(frame.frame - frame.frame.iloc[0]) / 2000)
