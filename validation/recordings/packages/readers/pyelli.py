"""Reads files of the package pyelli."""

import io

import numpy as np


def mueller(content, between):
    """Wavelengths in nm and the sixteen elements of a Mueller matrix, row by row, of a file with a line each wavelength."""
    table = np.loadtxt(io.BytesIO(content), comments=";")
    table = table[(table[:, 0] > between[0]) & (table[:, 0] < between[1])]
    return table[:, 0], table[:, 1:].T
