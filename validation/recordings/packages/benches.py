"""Formats of the fourteenth set, from bytes to columns, and the models that two of it share (the other formats are in reading.py, instruments.py, rigs.py, loggers.py, stations.py and housekeeping.py)."""

import gzip
import io
import re

import numpy as np
import pandas as pd
from fitting import lag, terms, usual
from reading import csv
from rigs import since

IBW_DATA = {2: 126, 5: 384}


def mast_logger(*contents):
    """Rows of a logger for masts, one file after another, below the header of each, and seconds since the first; packed files are unpacked."""
    frames = []
    for content in contents:
        plain = gzip.decompress(content) if content[:2] == b"\x1f\x8b" else content
        table = plain[plain.index(b"\n", plain.index(b"\nData") + 1) + 1 :]
        frames.append(pd.read_csv(io.StringIO(table.decode("latin1")), sep="\t"))
    frame = pd.concat(frames, ignore_index=True)
    when = pd.to_datetime(frame.iloc[:, 0])
    return pd.concat([frame, pd.DataFrame({"when": when, "time_s": (when - when.iloc[0]).dt.total_seconds()})], axis=1)


def own_supplies(diagnosis, *names):
    """Supplies of a logger by their names, in mV, each the middle between the smallest and the largest of a minute, while its battery tells a number."""
    frame = mast_logger(diagnosis)
    frame = frame[frame.BATTERY_V_Min > 1]
    middles = {name: ((frame[f"{name}_Min"] + frame[f"{name}_Max"]) * 500).round(3) for name in names}
    return pd.DataFrame({"when": frame.when, "time_s": since(frame.time_s), **middles})


def tower(content, first, last, *names):
    """Half hours of a tower from one day to before another, in which these columns have numbers, and seconds since the first."""
    frame = csv(content, usecols=["TIMESTAMP_END", *names], na_values=["-9999", "-9999.0000"])
    when = pd.to_datetime(frame.TIMESTAMP_END.astype(str), format="%Y%m%d%H%M")
    frame = frame.assign(when=when)[(when >= first) & (when < last)].dropna()
    return frame.assign(time_s=(frame.when - frame.when.iloc[0]).dt.total_seconds())


def radiation(content, first, last):
    """Minutes of a station for radiation from one day to before another: seconds since the first of them, beam, global and diffuse in W/m2, air in degC."""
    frame = csv(gzip.decompress(content)).dropna()
    when = pd.to_datetime(frame.date + " " + frame.time)
    frame = frame.assign(when=when, air_c=frame.temp - 273.15)[(when >= first) & (when < last)]
    return frame.assign(time_s=(frame.when - frame.when.iloc[0]).dt.total_seconds())


def restart(frame):
    """A frame whose clock begins at its first row."""
    return frame.assign(time_s=since(frame.time_s))


def spec_scans(content, *scans):
    """Scans of a beamline's log by their numbers, one after another, with seconds since the first point."""
    rows, names, number = [], [], None
    for line in content.decode("latin1").splitlines():
        if line.startswith("#S "):
            number = int(line.split()[1])
        elif line.startswith("#L "):
            names = re.split(r"  +", line[3:].strip())
        elif number in scans and line[:1].isdigit() and len(line.split()) == len(names):
            rows.append(dict(zip(names, map(float, line.split()))))
    frame = pd.DataFrame(rows)
    return frame.assign(time_s=since(frame.Epoch).round(3))


def ibw(content):
    """Numbers of a wave of an amplifier for cells (4 bytes each, largest byte first)."""
    start = IBW_DATA[int.from_bytes(content[:2], "big")]
    return np.frombuffer(content, ">f4", 12000, start).astype(float)


def cell_voltage(current, voltage, first, last):
    """A cell between two rows, 4000 a second: seconds, current in pA, voltage in mV."""
    part = slice(first, last)
    return {"time_s": np.arange(last - first) * 0.00025, "current_pa": ibw(current)[part], "voltage_mv": ibw(voltage)[part]}


def cell_models(c, hand_built):
    """Models of a cell whose skin is a capacitor, that which is told under its name `hand_built`."""
    y, x, t = c["voltage_mv"], c["current_pa"], c["time_s"]
    late = lambda p: lag(x, t, abs(p) * 0.01)
    return y, {
        **usual(y, x, t, 0.01),
        "line and lag": terms(y, lambda p: [x, late(p[0])], [2.0]),
        hand_built: terms(y, lambda p: [late(p[0]), late(p[1])], [2.0, 20.0]),
        "lag, and drift": terms(y, lambda p: [late(p[0]), t], [2.0]),
        "lag, and square": terms(y, lambda p: [late(p[0]), late(p[0]) ** 2], [2.0]),
        "lag, drift, and its square": terms(y, lambda p: [late(p[0]), t, t**2], [2.0]),
    }
