"""Reads files of the package tucavoc."""

import numpy as np
import pandas as pd
from formats.clock import seconds

AIR = "air"


def chromatograph(content, first, second):
    """Areas of two peaks in thousands, of air, an hour a row, where both are there; seconds since the first."""
    lines = content.decode("latin1").splitlines()
    names = [name for name in lines[1].split() if name != "-"]
    rows = [text.split() for text in lines[3:] if text.strip()]
    rows = [cells for cells in rows if cells[3] == AIR]
    when = pd.to_datetime([cells[0] + cells[1] for cells in rows], format="%y%m%d%H%M")
    areas = {name: np.array([float(cells[4 + names.index(name)]) for cells in rows]) / 1000 for name in (first, second)}
    frame = pd.DataFrame({"time_s": seconds(when), **areas})
    return frame[(frame[first] > 0) & (frame[second] > 0)]
