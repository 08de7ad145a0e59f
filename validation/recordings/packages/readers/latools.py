"""Reads files of the package latools."""

from formats.text import csv


def isotopes(content, first):
    """Counts of a mass spectrometer by isotope, from where that of the `first` is there."""
    frame = csv(content, skiprows=3).dropna()
    return frame[frame[first].notna()].astype(float)
