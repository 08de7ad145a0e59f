"""Reads files of the package pyEDM: the sea at piers, gates of a canal, and the brain of a fly."""

from durations import YEAR
from formats.clock import seconds, since_first
from formats.text import csv

FRAME_S = 1.0  # how long a frame takes is not told


def piers(content):
    """Warmth of the sea at two piers, a row a year; each less its mean and over its scatter."""
    frame = csv(content)
    return {"time_s": since_first(frame.year * YEAR), "newport": frame.np_sst, "scripps": frame.sio_sst}


def gates(content):
    """Water that goes through gates, a row a week, in the package's unit."""
    frame = csv(content)
    return {"time_s": seconds(frame.Date), "flow": frame.iloc[:, 1]}


def fly(content, part):
    """How bright a part of a fly's brain is, beside how quickly the fly walks and turns, a row each tenth frame."""
    frame = csv(content)
    return {"time_s": since_first(frame["index"] * FRAME_S), "walk": frame.FWD, "turn": frame["Left_Right"], "glow": frame[part]}
