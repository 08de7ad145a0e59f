"""Formats of the thirtieth set, from bytes to columns (the others are in reading.py, instruments.py, rigs.py, loggers.py, stations.py, housekeeping.py, benches.py, receivers.py, recorders.py, probes.py, sensors.py, monitors.py, meters.py, dials.py, gauges.py, counters.py, pickups.py, scales.py, levels.py, needles.py, pointers.py and tellers.py)."""

import io

import numpy as np
import pandas as pd
from fitting import line, scaled, terms
from meters import of_drivers
from pickups import clocks
from reading import csv, means, seconds

GAUGES = {"wire_v": "WGM701_Voltage (V)", "convection_v": "CVM211_Voltage (V)", "upper_v": "Baratron626D_1KT_Voltage (V)", "lower_v": "Baratron626D_1T_Voltage (V)"}
PLAUSIBLE = {"BME680_Temp": (10, 45), "Temp_LSM9DS1": (10, 45), "Pressure": (990, 1040), "Humidity": (10, 95)}
MINUTE = len("2025-05-06T00:00")


def permeation(content, every, *names, begin=0, lower=None):
    """Volts of some gauges of a rig in which hydrogen goes through a wall, means of so many rows, from a second on; `lower` holds the lower gauge between two volts. Seconds since the first mean."""
    frame = csv(content, parse_dates=["RealTimestamp"])
    t = seconds(frame.RealTimestamp)
    kept = t > begin
    if lower is not None:
        kept &= frame[GAUGES["lower_v"]].between(*lower, inclusive="neither").to_numpy()
    clock = means(t[kept], every)
    return {"time_s": np.round(clock - clock[0], 3), **{name: means(frame[GAUGES[name]].to_numpy()[kept], every) for name in names}}


def one_session(content, session, **names):
    """Columns of one session of a mass spectrometer that has dates and times, in their order; seconds since the first."""
    frame = csv(content)
    frame = frame[frame.Session == session]
    when = pd.to_datetime(frame.Date + " " + frame.Time)
    frame = frame.assign(time_s=when).sort_values("time_s", kind="stable")
    return {"time_s": seconds(frame.time_s), **{name: frame[column].to_numpy() for name, column in names.items()}}


def by_session(content, **names):
    """Columns of all sessions of a mass spectrometer, a run a session, numbered as they come; rows that miss a number are left out."""
    frame = csv(content).dropna()
    number = {session: k for k, session in enumerate(dict.fromkeys(frame.Session), 1)}
    frame = frame.assign(run=frame.Session.map(number)).sort_values("run", kind="stable")
    return {"run": frame.run.to_numpy(), **{name: frame[column].to_numpy() for name, column in names.items()}}


def box(content, days, least=None, **names):
    """Medians of a minute of a box of sensors in some days, minutes whose air is plausible; `least` is a column and what it has to be more than. Seconds since the first."""
    frame = csv(content, dtype={"Timestamp": str})
    frame = frame[frame.Timestamp.str.fullmatch(days + r"T\d\d:\d\d:\d\d", na=False)]
    frame = frame.groupby(frame.Timestamp.str[:MINUTE]).median(numeric_only=True)
    for column, (low, high) in PLAUSIBLE.items():
        frame = frame[frame[column].between(low, high)]
    if least is not None:
        frame = frame[frame[least[0]] > least[1]]
    return {"time_s": seconds(pd.to_datetime(frame.index.to_series())), **{name: frame[column].to_numpy() for name, column in names.items()}}


def cruise(content, first, last, **names):
    """Columns of a cruise from one row to another; seconds since the first."""
    frame = csv(content, sep="\t", parse_dates=["datetime"]).iloc[first:last]
    return {"time_s": seconds(frame.datetime), **{name: frame[column].to_numpy() for name, column in names.items()}}


def films(content, first, second):
    """Light that two films scatter, beside its shift in 1/cm, which is the first line; a line a film, counted from 0."""
    table = np.loadtxt(io.BytesIO(content))
    return {"shift_1_cm": table[0], "first": table[1 + first], "second": table[1 + second]}


def of_films(c):
    """Models of the light of one film over that of another."""
    y, x, place = c["second"], c["first"], c["shift_1_cm"]
    u, v = scaled(x), scaled(place)
    return y, {
        **of_drivers(y, x, place=place),
        "gain by place": line(y, x, v * x),
        "square, place, bent": line(y, x, u**2, v, v**2),
        "cube, and place": line(y, x, u**2, u**3, v),
        "logarithm": line(y, x, np.log(x)),
        "power": terms(y, lambda p: [x ** p[0]], [0.9]),
        "moved": terms(y, lambda p: [np.interp(place - p[0], place, x)], [0.1]),
        "moved, and place": terms(y, lambda p: [np.interp(place - p[0], place, x), v], [0.1]),
    }


def drifts(y, x, t, unit):
    """What is tried beside a clock: drifts that bend, by the logarithm and to a rest, slopes that drift, a square and a day."""
    u, w = scaled(x), scaled(t)
    return {
        **clocks(y, x, t, unit),
        "cube": line(y, x, u**2, u**3),
        "drift, and its square": line(y, x, w, w**2),
        "drift, and square": line(y, x, w, u**2),
        "drift by the logarithm": line(y, x, np.log(t + unit)),
        "drift to a rest": terms(y, lambda p: [x, np.exp(-t / ((1 + abs(p[0])) * unit))], [100.0]),
        "slope that drifts": line(y, x, w, u * w),
    }
