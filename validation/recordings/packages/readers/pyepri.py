"""Reads files of the package pyepri."""

import numpy as np
from formats.pickled import plain


def radicals(*contents, every):
    """Spectra of a spectrometer that goes through a field, by the step of the field."""
    return [np.asarray(plain(content)["DAT"], float)[::every] for content in contents]
