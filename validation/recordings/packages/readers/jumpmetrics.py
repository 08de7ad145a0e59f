"""Reads files of the package jumpmetrics."""

from formats.text import csv


def force_plates(content):
    """Forces and moments of two force plates, 2000 times a second: Fx, Fy, Fz, Mx, My, Mz of the first, then of the second."""
    return csv(content, header=None, skip_blank_lines=True).to_numpy(float)
