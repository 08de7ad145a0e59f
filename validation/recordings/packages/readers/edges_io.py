"""Reads files of the package edges-io, and holds models that its recordings share."""

import re

import numpy as np
import pandas as pd
from formats.clock import seconds
from models.fitting import line, terms
from models.lags import usual

BOX = {"100": "receiver_c", "101": "ambient_c", "102": "hot_c", "103": "box_c", "106": "drive_pct", "150": "battery_v", "152": "current_a"}


def field_receiver(content):
    """Rows of a receiver's own log, ten lines each, in which all of its numbers are told, and seconds since the first."""
    lines = content.decode("latin1").splitlines()
    rows = []
    for first in [k for k, text in enumerate(lines[:-9]) if re.fullmatch(r"\d{4}_\d{3}_\d{2}", text)]:
        told = dict(text.split() for text in lines[first + 2 : first + 10] if len(text.split()) == 2)
        if set(BOX) <= set(told):
            day, clock = lines[first].split("_"), lines[first + 1].split()[3]
            when = pd.to_datetime(f"{day[0]} {day[1]} {clock}", format="%Y %j %H:%M:%S")
            rows.append({"when": when, **{name: float(told[key]) for key, name in BOX.items()}})
    frame = pd.DataFrame(rows)
    return frame.assign(time_s=seconds(frame.when))


def hut(content):
    """Rows of the weather log of a receiver's hut, one each five minutes: temperatures in degC, humidity in per cent, and seconds since the first."""
    rows = []
    for text in content.decode("latin1").splitlines():
        clock, *told = text.replace(",", " ").split()
        numbers = {told[k]: float(told[k + 1]) for k in range(0, len(told), 3)}
        rows.append({"when": receiver_time(clock), **numbers})
    frame = pd.DataFrame(rows)
    warm = frame[["rack_temp", "ambient_temp", "frontend"]].sub(273.15).round(2)
    warm.columns = ["rack_c", "air_c", "receiver_c"]
    return pd.concat([frame[["when", "ambient_hum"]], warm], axis=1).assign(time_s=seconds(frame.when))


def thermostat(content):
    """Rows of the log of a thermostat, one each ten minutes: its time and its drive in per cent."""
    rows = [text.split() for text in content.decode("latin1").splitlines()]
    return pd.DataFrame({"when": [receiver_time(row[0]) for row in rows], "drive_pct": [float(row[8]) for row in rows]})


def receiver_time(text):
    """A time that is told as year, day of the year, hour, minute, second."""
    return pd.to_datetime(text, format="%Y:%j:%H:%M:%S")


def thermostat_models(y, x, t):
    """What is tried where a thermostat holds a temperature until it is at its end: bends of several kinds, and a knee from which on the reading rises."""
    knee = lambda p: np.maximum(x - p[0], 0)
    return {
        **usual(y, x, t, 600),
        "cube": line(y, x, x**2, x**3),
        "knee": terms(y, lambda p: [x, knee(p)], [43.0]),
        "knee, and drift": terms(y, lambda p: [x, knee(p), t], [43.0]),
        "knee, and square": terms(y, lambda p: [x, knee(p), knee(p) ** 2], [43.0]),
    }
