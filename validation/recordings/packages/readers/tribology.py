"""Reads files of the package tribology: heights in um along parts of roller bearings, over the place in mm, as a stylus that goes along them tells."""

import numpy as np


def profile(content):
    """Places in mm and heights in um, rows by the place."""
    return np.array(content.split(), float).reshape(-1, 2).T


def near_top(places, *heights, below, every):
    """One row in so many of those where no height is lower than so many um below zero."""
    kept = np.flatnonzero(np.min(heights, axis=0) > -below)[::every]
    return places[kept], *(values[kept] for values in heights)
