"""Reads files of the package scikit-gstat."""

from formats.text import csv


def river_bank_soil(content, **names):
    """Columns of a table of soil by the names that they are to have, rows without a gap."""
    frame = csv(content).dropna()
    return {name: frame[column] for name, column in names.items()}
