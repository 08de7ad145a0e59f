"""Exports of a plate reader."""

import numpy as np
from formats.clock import TIME_OF_DAY


def densities(content, *wells):
    """Optical density of some wells of a plate; seconds since the reader was started."""
    lines = [text.split("\t") for text in content.decode("latin1").splitlines()]
    head = next(cells for cells in lines if cells[0] == "Time")
    rows = [cells for cells in lines if TIME_OF_DAY.fullmatch(cells[0])]
    seconds = [sum(int(part) * unit for part, unit in zip(cells[0].split(":"), (3600, 60, 1))) for cells in rows]
    return {"time_s": seconds, **{well: np.array([float(cells[head.index(well)]) for cells in rows]) for well in wells}}
