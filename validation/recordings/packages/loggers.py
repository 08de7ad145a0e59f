"""Formats of the eleventh set, from bytes to columns (the others are in reading.py, instruments.py and rigs.py), and models that several of its recordings have in common."""

import gzip
import io
import struct

import numpy as np
import pandas as pd
from fitting import line, terms, usual
from reading import csv, seconds


def since(times):
    """Seconds since the first of some times."""
    return seconds(pd.Series(pd.DatetimeIndex(times)))


def trajectory(content):
    """Axes of a machine that irradiates, one snapshot each 20 ms: a command and an answer a column pair, in the order of its file; 13 axes, then carriages and leaves."""
    axes = struct.unpack_from("<i", content, 40)[0]
    samples = struct.unpack_from(f"<{axes}i", content, 44 + 4 * axes)
    _, beams, _, snapshots = struct.unpack_from("<4i", content, 44 + 8 * axes)
    wide = 2 * sum(samples)
    return np.frombuffer(content, "<f4", wide * snapshots, 1024 + 80 * beams).reshape(snapshots, wide).astype(float)


def followed(y, x, t, unit=0.05):
    """Models of an axis `y` that follows its command `x`."""
    speed = np.gradient(x, t)
    return {
        **usual(y, x, t, unit),
        "speed": line(y, x, speed),
        "direction": line(y, x, np.sign(speed)),
    }


def motes(content):
    """A logger of motion, calibrated, 73 rows a second: seconds, and its channels by name."""
    frame = csv(gzip.decompress(content), skiprows=[0, 2])
    frame = frame.rename(columns=lambda name: name.removeprefix("Shimmer_952D_").removesuffix("_CAL"))
    return frame.assign(time_s=(frame.Timestamp_Unix - frame.Timestamp_Unix.iloc[0]) / 1000)


def pairs(content):
    """Seconds and a number, a row each."""
    return np.loadtxt(io.BytesIO(content))


def partector(content):
    """A counter of fine particles, every fourth row: its columns by name."""
    lines = [row.split("\t") for row in content.decode("latin1").splitlines()]
    start = next(k for k, row in enumerate(lines) if row[0] == "time")
    return pd.DataFrame([[float(v) for v in row[:12]] for row in lines[start + 1 :] if len(row) >= 12], columns=lines[start][:12]).iloc[::4]


def impactor(content):
    """A low-pressure impactor, every fifth second: seconds and its columns by name, from the charger to its thermometers."""
    lines = content.decode("latin1").splitlines()
    start = next(k for k, row in enumerate(lines) if row.startswith("Date Time"))
    cells = [row.split(",") for row in lines[start + 1 :] if row[:1] == "2"][::5]
    frame = pd.DataFrame([[float(v) for v in row[17:32]] for row in cells], columns=lines[start].split(",")[17:32])
    return frame.assign(time_s=since([row[0] for row in cells]))


def soot(content):
    """A meter of soot on a filter, a row a minute, without its last row and those in which a colour said nothing."""
    frame = csv(content).iloc[:-1].dropna(subset=["UV BC1", "Red BC1"])
    return frame.assign(time_s=since(frame["Date / time local"]))


def string(content, rows=2100):
    """A logger of thermistors in the ground, each 8 hours: seconds, battery in V, ten thermometers from above to below, and that of the logger. Until it was dug out."""
    cells = [row.replace('"', "").split(",") for row in content.decode("latin1").splitlines() if row.startswith("20")][:rows]
    frame = pd.DataFrame([[float(row[k]) for k in (2, *range(3, 13), 26)] for row in cells], columns=["battery_v", *range(1, 11), "logger_c"])
    return frame.assign(time_s=since([row[0] for row in cells]))


def bench(content):
    """Five thermistors of a logger on a bench, every fourth hour from the 2000th row on, with seconds since the first."""
    cells = [row.split(",") for row in content.decode("latin1").splitlines() if row[:1].isdigit()][2000::4]
    frame = pd.DataFrame([[float(v) for v in row[2:7]] for row in cells], columns=range(1, 6))
    return frame.assign(time_s=since(pd.to_datetime([row[1] for row in cells], format="%d.%m.%Y %H:%M:%S")))


def two_probes(content):
    """Two probes of a logger, every sixth hour from the second day on, with seconds since the first."""
    frame = csv(content, skiprows=1, encoding="utf-8-sig").iloc[:, [1, 2, 3, 4]]
    frame.columns = ["day", "hour", "first", "second"]
    frame = frame.dropna().iloc[24::6]
    return frame.assign(time_s=since(pd.to_datetime(frame.day + " " + frame.hour, format="%m/%d/%y %I:%M:%S %p")))


def housing(content):
    """Inside of the housing of a logger, an hour a row from the second day on: temperature, pressure, humidity, battery, seconds."""
    frame = csv(content, skiprows=[1, 2, 3, 4, 5]).iloc[24:]
    return frame.assign(time_s=since(frame.timestamp))


def tower(content, *names):
    """Half hours of a tower above a field in which these columns have numbers, with seconds since the first."""
    frame = csv(content, low_memory=False)
    when = pd.to_datetime(frame.TIMESTAMP_END.astype(str), format="%Y%m%d%H%M", errors="coerce")
    frame = frame[list(names)].apply(pd.to_numeric, errors="coerce").replace(-9999, np.nan).assign(when=when).dropna()
    return frame.assign(time_s=since(frame.when))


def fades(t, share):
    """One at the first row, and less by a factor of e after a share of the whole time."""
    return np.exp(-t / ((abs(share) + 1e-3) * t[-1]))


def rests(y, t):
    """Models of something `y` that comes to rest."""
    return {
        "constant": line(y),
        "drift": line(y, t),
        "square": line(y, t, t**2),
        "logarithm": line(y, np.log(t + 60)),
        "exponential": terms(y, lambda p: [fades(t, p[0])], [0.3]),
        "exponential, and drift": terms(y, lambda p: [fades(t, p[0]), t], [0.3]),
    }
