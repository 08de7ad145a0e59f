"""Reads files of the package nitime."""

import numpy as np
from formats.text import csv


def shown_events(content, period):
    """How bright a part of a brain is in a scanner, a row each so many seconds, and whether something was shown: 1 then, else 0."""
    frame = csv(content)
    return {"time_s": np.arange(len(frame)) * period, "shown": (frame.events > 0).astype(int), "signal": frame.bold}
