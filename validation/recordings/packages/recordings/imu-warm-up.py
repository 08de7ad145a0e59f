"""Thermometer of a motion sensor in its first minutes: self-heating of first order."""

import numpy as np
from formats.text import csv
from models.fitting import line, terms

HAND_BUILT = "exponential"


def rows(content):
    d = csv(content)
    return {"time_s": (d.iloc[:, 0] - d.iloc[0, 0]) / 256.0, "board_temp": d.iloc[:, 2]}


def models(c):
    y, t = c["board_temp"], c["time_s"]
    return y, {"line": line(y, t), HAND_BUILT: terms(y, lambda p: [np.exp(-t / abs(p[0]))], [40.0])}
