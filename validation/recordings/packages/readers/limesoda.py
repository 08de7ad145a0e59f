"""Reads files of the package limesoda."""

from formats.arrays import array


def soil_samples(content, *places):
    """Columns of a table of soil samples by their place."""
    with array(content) as file:
        return file["dataset_data"][:, places].T
