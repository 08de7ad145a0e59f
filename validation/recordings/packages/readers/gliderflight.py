"""Reads files of the package gliderflight."""

import io

import numpy as np
import pandas as pd
from formats.clock import since_first


def sinking_glider(content):
    """Rows of a glider: seconds, pressure in bar, pitch in rad, volume that it has pumped in cm3, density of the water in kg/m3."""
    told = np.load(io.BytesIO(content), allow_pickle=False)[:5]
    frame = pd.DataFrame(told.T, columns=["time_s", "pressure_bar", "pitch_rad", "pumped_cm3", "density"])
    return frame.assign(time_s=since_first(frame.time_s).round(3))
