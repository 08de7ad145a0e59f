"""Reads files of the package spec2nexus."""

import pandas as pd
from formats.spec import scans


def every_second_point(content):
    """Every second point of all scans of a SPEC file, with seconds since the first."""
    frame = pd.concat(scans(content)).iloc[::2]
    return frame.assign(time_s=frame.Epoch - frame.Epoch.iloc[0])
