"""Reads files of the package polartools."""

import pandas as pd
from formats.clock import since_first
from formats.spec import scans


def some_scans(content, *numbers):
    """Scans of a beamline's log by their numbers, one after another, with seconds since the first point."""
    frame = pd.concat((scan for scan in scans(content) if scan.scan.isin(numbers).any()), ignore_index=True)
    return frame.assign(time_s=since_first(frame.Epoch).round(3))
