"""Reads files of the package ecov002-calval-tables."""

from formats.text import csv


def towers(content, *names):
    """Towers at the moments at which a satellite passed over them, in the order of these moments."""
    frame = csv(content)
    frame = frame.dropna(subset=list(names))
    return frame.sort_values(["eco_time_utc", "ID"], kind="stable")
