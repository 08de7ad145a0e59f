"""Reads files of the package pyelli."""

from formats.text import matrix


def mueller(content, between):
    """Wavelengths in nm and the sixteen elements of a Mueller matrix, row by row, of a file with a line each wavelength."""
    table = matrix(content, comments=";")
    table = table[(table[:, 0] > between[0]) & (table[:, 0] < between[1])]
    return table[:, 0], table[:, 1:].T
