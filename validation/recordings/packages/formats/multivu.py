"""Files of MultiVu, which runs magnetometers and cryostats."""

from formats.text import csv


def multivu(content):
    """The data of a file of a magnetometer or of a cryostat, below its header."""
    return csv(content[content.index(b"[Data]") + 7 :], encoding="latin1")
