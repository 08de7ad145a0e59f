"""Reads files of the package pyshimmer."""

import gzip

from formats.text import csv


def motion_logger(content):
    """A logger of motion, calibrated, 73 rows a second: seconds, and its channels by name."""
    frame = csv(gzip.decompress(content), skiprows=[0, 2])
    frame = frame.rename(columns=lambda name: name.removeprefix("Shimmer_952D_").removesuffix("_CAL"))
    return frame.assign(time_s=(frame.Timestamp_Unix - frame.Timestamp_Unix.iloc[0]) / 1000)
