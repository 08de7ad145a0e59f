"""Reads files of the package colour-science."""

import numpy as np
from formats.text import csv


def two_charts(first, second):
    """Reflectance of the same patches of two charts at the wavelengths that both have; a patch is a run."""
    one, other = (csv(content).set_index("wavelength") for content in (first, second))
    both = one.index.intersection(other.index)
    patches = len(one.columns)
    seen = [table.loc[both].to_numpy().T.ravel() for table in (one, other)]
    return {"run": np.repeat(np.arange(patches) + 1, len(both)), "nm": np.tile(both.to_numpy(), patches), "first": seen[0], "second": seen[1]}
