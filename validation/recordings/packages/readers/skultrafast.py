"""Reads files of the package skultrafast."""

from formats.arrays import array


def grating(content, *pixels):
    """Counts of some pixels while a grating turns, a row a step of it."""
    with array(content) as file:
        return file["probe"][:, pixels].T
