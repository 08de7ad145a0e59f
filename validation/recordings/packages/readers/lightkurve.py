"""Reads files of the package lightkurve."""

from durations import DAY
from formats.clock import since_first
from formats.text import csv


def shaken_star(content):
    """Light of a star in a telescope that rolls, without the rows in which its thrusters fire: seconds, light over its usual one, and the way of the star over the camera in pixels."""
    frame = csv(content, skipinitialspace=True, index_col=False)
    frame = frame[frame["Thrusters On"] == 0]
    return {"time_s": (since_first(frame.iloc[:, 0]) * DAY).round(1), "light": frame["Raw Flux"], "way_px": frame.arclength}
