"""Reads files of the package firescipy."""

from formats.text import csv


def thermobalance(content):
    """A thermobalance: seconds, weight in mg, temperature of the sample."""
    return csv(content, sep="\t", skiprows=2, header=None, encoding="latin1", names=["row", "sample_c", "time_s", "weight_mg", "program_c"])
