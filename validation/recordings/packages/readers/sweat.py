"""Reads files of the package sweat."""

import re

import pandas as pd
from formats.clock import seconds


def trackpoints(content):
    """Points of a training file (TCX) that have all of time, place, heart rate, speed and power: numbers by name, and seconds since the first."""
    tags = {"when": "Time", "north": "LatitudeDegrees", "east": "LongitudeDegrees", "heart": "Value", "speed": "ns3:Speed", "watts": "ns3:Watts"}
    points = re.findall(r"<Trackpoint>(.*?)</Trackpoint>", content.decode(), re.S)
    found = [[re.search(rf"<{tag}>([^<]*)<", point) for tag in tags.values()] for point in points]
    frame = pd.DataFrame([[cell[1] for cell in row] for row in found if all(row)], columns=list(tags))
    when = pd.to_datetime(frame.pop("when"))
    return frame.astype(float).assign(time_s=seconds(when))
