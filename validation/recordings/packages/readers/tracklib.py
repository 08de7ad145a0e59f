"""Reads files of the package tracklib."""

import re

import numpy as np
import pandas as pd
from formats.clock import since_first

# metres of a degree of latitude; and the ellipsoid of satellites: its radius in m, and the square of its eccentricity
DEGREE, RADIUS, OVAL = 111194, 6378137, 6.69437999014e-3
POINT = re.compile(r'<trkpt lat="([^"]+)" lon="([^"]+)">\s*<ele>[^<]*</ele>\s*<time>([^<]*)</time>')


def watch(content):
    """Seconds, latitude and longitude in degrees of the points of a watch (GPX)."""
    found = POINT.findall(content.decode())
    north, east = np.array([point[:2] for point in found], float).T
    return seconds_of_july([point[2] for point in found]), north, east


def receiver(content):
    """The same of a receiver that tells places from the middle of the Earth (RTKLIB)."""
    lines = [line.split() for line in content.decode().splitlines() if line[:1] != "%"]
    x, y, z = np.array([line[2:5] for line in lines], float).T
    out = np.hypot(x, y)
    north = np.arctan2(z, out * (1 - OVAL))
    for _ in range(5):
        bent = RADIUS / np.sqrt(1 - OVAL * np.sin(north) ** 2)
        north = np.arctan2(z + OVAL * bent * np.sin(north), out)
    return seconds_of_july([f"{line[0]} {line[1]}" for line in lines]), np.degrees(north), np.degrees(np.arctan2(y, x))


def seconds_of_july(texts):
    """Seconds since 2021-07-01 of times as they are told, all as if at one place."""
    return (pd.to_datetime(pd.Series(texts), utc=True, format="mixed") - pd.Timestamp("2021-07-01", tz="UTC")).dt.total_seconds().to_numpy()


def two_tracks(first, second, way, every, late=0):
    """Each so many points of a second track while the first lasts: seconds since the first of them, and how far north or east both are in m. The first is straight between its points, and its clock is put forward by `late` seconds."""
    then, now = first[0] + late, second[0]
    kept = (now >= then[0] + 5) & (now <= then[-1] - 5)
    wide = DEGREE * (np.cos(np.radians(second[1].mean())) if way == "east" else 1)
    at = {"north": 1, "east": 2}[way]
    there, here = np.interp(now[kept], then, first[at]), second[at][kept]
    told = {"time_s": since_first(now[kept]), "first_m": (there - there.mean()) * wide, "second_m": (here - there.mean()) * wide}
    return {name: np.round(values[::every], 3) for name, values in told.items()}
