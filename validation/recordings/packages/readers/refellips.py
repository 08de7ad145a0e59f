"""Reads files of the package refellips."""

from formats.text import csv


def zones(content):
    """Readings of an ellipsometer by the zone in which its polarisers stood: angle of the light in deg, delta and psi in deg; zone 0 is the mean of all four."""
    names = ["nm", "bandwidth", "angle", "delta", "psi", "zone"]
    frame = csv(content, sep="\t", skiprows=2, header=None, encoding="latin1").iloc[:, :6].set_axis(names, axis=1)
    return {zone: rows.reset_index(drop=True) for zone, rows in frame.groupby("zone")}
