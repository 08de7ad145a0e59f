"""Reads files of the package py-wave-runup."""

from formats.text import csv


def runup(content, beach):
    """How high waves run up one beach, the height of the waves, how steep the beach is, and how long a wave lasts."""
    frame = csv(content, encoding="utf-8-sig")
    frame = frame[frame.Beach == beach]
    names = {"height_m": "Hs [m]", "slope": "tanB [-]", "period_s": "Tp [s]", "runup_m": "R2% (-SWL) [m]"}
    return {name: frame[column].to_numpy() for name, column in names.items()}
