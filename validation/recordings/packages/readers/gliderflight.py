"""Reads files of the package gliderflight."""

import pandas as pd
from formats.arrays import array
from formats.clock import since_first


def sinking_glider(content):
    """Rows of a glider: seconds, pressure in bar, pitch in rad, volume that it has pumped in cm3, density of the water in kg/m3."""
    told = array(content)[:5]
    frame = pd.DataFrame(told.T, columns=["time_s", "pressure_bar", "pitch_rad", "pumped_cm3", "density"])
    return frame.assign(time_s=since_first(frame.time_s).round(3))
