"""Formats of the fifteenth set, from bytes to columns, and the models that several of it share (the other formats are in reading.py, instruments.py, rigs.py, loggers.py, stations.py, housekeeping.py and benches.py)."""

import re

import numpy as np
import pandas as pd
from fitting import lag, line, terms, usual
from reading import csv
from rigs import since
from stations import toa5

LOADS = "date time lna_v lna_ohm lna_c switch_v switch_ohm switch_c load_v load_ohm load_c room_c".split()
BOX = {"100": "receiver_c", "101": "ambient_c", "102": "hot_c", "103": "box_c", "106": "drive_pct", "150": "battery_v", "152": "current_a"}
BROKEN = 900


def load_thermistors(content):
    """Rows of a calibration of a radio receiver, one each half minute: voltages, resistances and temperatures of its thermistors, and seconds since the first."""
    frame = csv(content, encoding="latin1")
    frame.columns = LOADS
    when = pd.to_datetime(frame.date + " " + frame.time, format="%m/%d/%Y %H:%M:%S")
    return frame.assign(time_s=(when - when.iloc[0]).dt.total_seconds())


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
    return frame.assign(time_s=(frame.when - frame.when.iloc[0]).dt.total_seconds())


def hut(content):
    """Rows of the weather log of a receiver's hut, one each five minutes: temperatures in degC, humidity in per cent, and seconds since the first."""
    rows = []
    for text in content.decode("latin1").splitlines():
        clock, *told = text.replace(",", " ").split()
        numbers = {told[k]: float(told[k + 1]) for k in range(0, len(told), 3)}
        rows.append({"when": clocked(clock), **numbers})
    frame = pd.DataFrame(rows)
    warm = frame[["rack_temp", "ambient_temp", "frontend"]].sub(273.15).round(2)
    warm.columns = ["rack_c", "air_c", "receiver_c"]
    return pd.concat([frame[["when", "ambient_hum"]], warm], axis=1).assign(time_s=(frame.when - frame.when.iloc[0]).dt.total_seconds())


def thermostat(content):
    """Rows of the log of a thermostat, one each ten minutes: its time and its drive in per cent."""
    rows = [text.split() for text in content.decode("latin1").splitlines()]
    return pd.DataFrame({"when": [clocked(row[0]) for row in rows], "drive_pct": [float(row[8]) for row in rows]})


def clocked(text):
    """A time that is told as year, day of the year, hour, minute, second."""
    return pd.to_datetime(text, format="%Y:%j:%H:%M:%S")


def two_stations(slow, sonic):
    """Seconds of two thermometers with hygrometers, and means of a second of two sonic thermometers without the rows that one of them could not read."""
    frame, quick = toa5(slow), toa5(sonic)
    names = [f"{name}_{k}" for k in (1, 2) for name in ("u", "v", "w", "Ts")]
    quick.loc[(quick[names] > BROKEN).any(axis=1), names] = np.nan
    means = {f"sonic{k}_c": np.nanmean(quick[f"Ts_{k}"].to_numpy().reshape(-1, 20), axis=1).round(4) for k in (1, 2)}
    when = pd.to_datetime(frame.TIMESTAMP)
    return frame.assign(time_s=since((when - when.iloc[0]).dt.total_seconds()), **means)


def late_models(y, x, t, unit):
    """What is tried where heat comes late: beside the usual models a lag with a drift, two lags, and a lag of a lag; lags begin at half a unit, in s."""
    late = lambda p: lag(x, t, abs(p) * unit)
    return {
        **usual(y, x, t, unit),
        "line and lag": terms(y, lambda p: [x, late(p[0])], [0.5]),
        "lag, and drift": terms(y, lambda p: [late(p[0]), t], [0.5]),
        "lag, drift, and its square": terms(y, lambda p: [late(p[0]), t, t**2], [0.5]),
        "two lags": terms(y, lambda p: [lag(late(p[0]), t, abs(p[1]) * unit)], [0.5, 0.2]),
    }


def bent_models(y, x, t):
    """What is tried where a thermostat holds a temperature until it is at its end: bends of several kinds, and a knee from which on the reading rises."""
    knee = lambda p: np.maximum(x - p[0], 0)
    return {
        **usual(y, x, t, 600),
        "cube": line(y, x, x**2, x**3),
        "knee": terms(y, lambda p: [x, knee(p)], [43.0]),
        "knee, and drift": terms(y, lambda p: [x, knee(p), t], [43.0]),
        "knee, and square": terms(y, lambda p: [x, knee(p), knee(p) ** 2], [43.0]),
    }
