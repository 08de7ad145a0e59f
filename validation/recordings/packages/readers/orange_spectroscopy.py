"""Reads files of the package orange-spectroscopy."""

import numpy as np
from formats.text import csv


def tissue(content, kind, **wavenumbers):
    """How much infrared light one kind of tissue takes away near some wavenumbers, a spectrum a row."""
    frame = csv(content, skiprows=[1, 2])
    frame = frame[frame.type == kind]
    told = frame.columns[1:].astype(float)
    return {name: frame.iloc[:, 1 + np.argmin(np.abs(told - one))] for name, one in wavenumbers.items()}
