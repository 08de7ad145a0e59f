"""Reads files of the package chemotools."""

import numpy as np
from formats.text import matrix


def bands(content, period, *wavenumbers):
    """How much light of some wavenumbers a broth takes away, a spectrum each so many seconds."""
    table = matrix(content, delimiter=",")
    told = {f"band_{one}": table[1:, np.argmin(np.abs(table[0] - one))] for one in wavenumbers}
    return {"time_s": np.arange(len(table) - 1) * period, **told}
