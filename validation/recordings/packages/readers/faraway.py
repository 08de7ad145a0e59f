"""Reads files of the package faraway."""

import bz2

from formats.text import csv


def book_table(content, **names):
    """Columns of a packed table by the names that they are to have."""
    frame = csv(bz2.decompress(content))
    return {name: frame[column] for name, column in names.items()}
