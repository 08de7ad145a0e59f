"""Reads files of the package dclab."""

import numpy as np
import pandas as pd


def cells(content, *names):
    """Cells that pass a camera, one by one, by the names of what it saw; seconds since the first, 2000 pictures a second; of those in one picture the first."""
    import netCDF4  # the other readers do without it

    with netCDF4.Dataset("memory", memory=content) as file:
        frame = pd.DataFrame({name: np.ma.filled(file["events"][name][:].astype(float), np.nan) for name in ("frame", *names)})
    frame = frame.drop_duplicates("frame")
    return frame.assign(time_s=(frame.frame - frame.frame.iloc[0]) / 2000)
