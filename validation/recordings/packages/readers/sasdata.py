"""Reads files of the package sasdata."""

import numpy as np
from formats.text import matrix


def polarised_neutrons(plus, minus, widest, every):
    """Neutrons that a sample scatters with their spin along the field and against it: part of the way that is across the field, as a square, and its length in 1/nm."""
    across, along, up, _ = matrix(plus, skiprows=2).T
    down = matrix(minus, skiprows=2)[:, 2]
    way = np.hypot(across, along)
    kept = np.flatnonzero((way < widest) & (up > 0) & (down > 0))[::every]
    return {"across": ((along / way) ** 2)[kept], "way_1_nm": 10 * way[kept], "against": down[kept], "along": up[kept]}
