"""Reads files of the package gaitkit: markers on people who walk, in mm, some frames a second."""

import json

import numpy as np
from models.drifts import usual_shifts_and_drifts
from models.drivers import drivers_and_drift, of_drivers


def walk(content):
    """Frames of a walk: seconds since the first, angles of joints in degrees and places of markers in mm, three columns each, by their names."""
    told = json.loads(content)
    frames = told["angle_frames"]
    angles = {name: np.array([frame[name] for frame in frames], float) for name in frames[0] if name.endswith("_angle")}
    markers = {name: np.array([frame["landmark_positions"][name] for frame in frames], float) for name in frames[0]["landmark_positions"]}
    return np.arange(len(frames)) / told["fps"], angles, markers


def foot(content, side, up):
    """Heights of three markers on one foot, mm, above an unknown height; `up` is the axis that goes up."""
    t, _, markers = walk(content)
    return {"time_s": t, **{f"{part}_mm": markers[f"{side}_{part}"][:, up] for part in ("ankle", "toe", "heel")}}


def foot_models(c):
    """Models of the heel over the ankle, beside the toe."""
    y, x, z, t = c["heel_mm"], c["ankle_mm"], c["toe_mm"], c["time_s"]
    return y, {
        **usual_shifts_and_drifts(y, x, t, 0.01),
        **of_drivers(y, x, toe=z),
        **drivers_and_drift(y, x, t, toe=z),
    }
