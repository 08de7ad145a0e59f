"""Reads files of the package eddycovtools."""

import numpy as np
import pandas as pd
from formats.clock import seconds
from formats.toa5 import toa5

BROKEN = 900


def two_stations(slow, sonic):
    """Seconds of two thermometers with hygrometers, and means of a second of two sonic thermometers without the rows that one of them could not read."""
    frame, quick = toa5(slow), toa5(sonic)
    names = [f"{name}_{k}" for k in (1, 2) for name in ("u", "v", "w", "Ts")]
    quick.loc[(quick[names] > BROKEN).any(axis=1), names] = np.nan
    means = {f"sonic{k}_c": np.nanmean(quick[f"Ts_{k}"].to_numpy().reshape(-1, 20), axis=1).round(4) for k in (1, 2)}
    when = pd.to_datetime(frame.TIMESTAMP)
    return frame.assign(time_s=seconds(when), **means)
