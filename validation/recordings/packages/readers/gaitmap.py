"""Reads files of the package gaitmap."""

import numpy as np
from formats.text import csv


def foot_pitch(markers, sensors, side):
    """How fast a foot pitches by its markers, 100 times a second, and how fast a gyroscope on the shoe says that it pitches and twists, between two of its rows; all in deg/s."""
    seen, worn = csv(markers, header=[0, 1], index_col=0), csv(sensors, header=[0, 1], index_col=0)
    t, clock = seen.index.to_numpy() / 100, worn.index.to_numpy() / 204.8
    along = (seen[f"{side[0].upper()}_TOE"] - seen[f"{side[0].upper()}_FCC"]).to_numpy()
    pitch = np.degrees(np.arctan2(along[:, 2], np.hypot(along[:, 0], along[:, 1])))
    gyro = {name: np.interp(t, clock, worn[(f"{side}_sensor", axis)]) for name, axis in (("twist", "gyr_z"), ("gyro", "gyr_y"))}
    return {"time_s": t, "markers": -np.gradient(pitch, t), **gyro}
