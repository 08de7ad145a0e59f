"""Formats of the twenty-ninth set, from bytes to columns (the others are in reading.py, instruments.py, rigs.py, loggers.py, stations.py, housekeeping.py, benches.py, receivers.py, recorders.py, probes.py, sensors.py, monitors.py, meters.py, dials.py, gauges.py, counters.py, pickups.py, scales.py, levels.py, needles.py and pointers.py)."""

import gzip
import io
import json
import struct

import numpy as np
import pandas as pd
from fitting import line, scaled, terms
from meters import DAY
from monitors import bends_with
from reading import csv, seconds

KELVIN = 273.15
INERTIAL, RECEIVER = ("/sensor/ins-d/pva", ">qB6d"), ("/sensor/ublox-ZED-F9T/pva", ">qB6d")
BAROMETER, ACCELEROMETER = ("/sensor/bmp388/baro_pressure", ">qd"), ("/sensor/vn-100/imu", ">qB3d")


def channel(content, name, form, head=39):
    """Numbers of one channel of a log of messages, of each a column; they begin so many bytes behind the begin of a message. The first is a time in ns."""
    rows, at, name = [], 0, name.encode()
    while at < len(content):
        letters, size = struct.unpack_from(">ii", content, at + 20)
        begin = at + 28 + letters
        if content[at + 28 : begin] == name:
            rows.append(struct.unpack_from(form, content, begin + head))
        at = begin + size
    clock, *told = zip(*rows)
    return (np.array(clock) - np.array(clock[0])) / 1e9, clock[0], np.array(told, float)


def beside(at, channel_of, begin, value):
    """Values of another channel at times of this one, straight between its rows; `begin` is the first time of this one in ns."""
    t, first, _ = channel_of
    return np.interp(at, t + (first - begin) / 1e9, value)


def speeds(told):
    """How fast something moves over the ground; a place and a speed have three numbers each, behind a number of the frame."""
    return np.hypot(told[4], told[5])


def drive_by_pressure(content):
    """Pressure in a car, its height and how fast it goes."""
    (t, begin, told), car = channel(content, *BAROMETER), channel(content, *INERTIAL)
    height, speed = (beside(t, car, begin, value) for value in (car[2][3], speeds(car[2])))
    return {"time_s": np.round(t, 4), "height_m": height, "speed_m_s": speed, "pressure_hpa": told[0] / 100}


def drive_by_speed(content, first, last):
    """How fast a car goes by two instruments, from one row of the receiver to another."""
    (t, begin, told), car = channel(content, *RECEIVER), channel(content, *INERTIAL)
    other = beside(t, car, begin, speeds(car[2]))
    return {"time_s": np.round(t[first:last] - t[first], 4), "inertial_m_s": other[first:last], "receiver_m_s": speeds(told)[first:last]}


def drive_by_force(content, slowest):
    """What an accelerometer feels along a car, over how much faster it gets, and how steep the road is: over each second in which it goes faster than the slowest."""
    (t, begin, told), car = channel(content, *INERTIAL), channel(content, *ACCELEROMETER)
    at = np.arange(1, int(t[-1]))
    speed, height = (np.interp(at, t, value) for value in (speeds(told), told[3]))
    felt = np.diff(beside(at, car, begin, np.cumsum(car[2][1])))
    middle = (speed[1:] + speed[:-1]) / 2
    kept = middle > slowest
    return {"time_s": at[:-1][kept], "gained_m_s2": np.diff(speed)[kept], "slope": np.diff(height)[kept] / middle[kept], "felt_m_s2": felt[kept]}


def lamp(content, number):
    """Light of one lamp at each setting, all wavelengths together."""
    frame = csv(content)
    told = frame[frame.Primary == number]
    return told.Setting.to_numpy(), told.iloc[:, 2:].sum(axis=1).to_numpy()


def setting(content, number):
    """One lamp over its setting."""
    return dict(zip(("setting", "light"), lamp(content, number)))


def of_two_lamps(c):
    """Models of the second lamp over the first."""
    y, x = c["second"], c["first"]
    u = scaled(x)
    return y, {
        "as it is": lambda seen: x,
        "zero": lambda seen: x + (y - x)[seen].mean(),
        **bends_with(y, x),
        "fourth power": line(y, x, u**2, u**3, u**4),
        **one_side(y, x, x.max() / 4),
    }


def two_lamps(first, second, number):
    """Two lamps of one kind at the same settings, in counts."""
    return {"first": lamp(first, number)[1], "second": lamp(second, number)[1]}


def days_of(content):
    """Numbers of days behind a head of three lines that ends with `"1d")`."""
    return np.array(content.decode().split('"1d")')[1].split(), float)


def valley(*contents, first, days, names):
    """Columns of days, so many from one on; seconds since the first."""
    return {"time_s": np.arange(days) * DAY, **{name: days_of(content)[first : first + days] for name, content in zip(names, contents)}}


def stack(content):
    """A stack that splits water, by the minute in the order of the clock: current by its hydrogen, warmth, volts of a cell."""
    frame = csv(content, parse_dates=["time"]).sort_values("time", kind="stable")
    return {"time_s": seconds(frame.time), **cells(frame)}


def cells(frame):
    """Current, warmth and volts of a cell."""
    return {"current_ma_cm2": frame.j, "warmth_degc": np.round(frame["T"] - KELVIN, 4), "volts": frame.V}


def runup(content, beach):
    """How high waves run up one beach, the height of the waves, how steep the beach is, and how long a wave lasts."""
    frame = pd.read_csv(io.BytesIO(content), encoding="utf-8-sig")
    frame = frame[frame.Beach == beach]
    names = {"height_m": "Hs [m]", "slope": "tanB [-]", "period_s": "Tp [s]", "runup_m": "R2% (-SWL) [m]"}
    return {name: frame[column].to_numpy() for name, column in names.items()}


def sorption(content, number, *pairs):
    """Branches of one measurement of what a solid takes up, one after another: pairs of columns, rows without the zeros that fill them up. The end of a column's name may have a blank."""
    frame = pd.DataFrame(json.loads(gzip.decompress(content))[number]["data"]).rename(columns=str.strip)
    rows = np.concatenate([frame[list(pair)].to_numpy(float) for pair in pairs])
    return rows[rows[:, 0] > 0].T


def one_side(y, x, width):
    """Models of what levels off: a root, a power, a hyperbola, a corner and what goes on behind it."""
    return {
        "root": line(y, np.sqrt(x)),
        "power": terms(y, lambda p: [x ** abs(p[0])], [0.8]),
        "hyperbola": terms(y, lambda p: [x / (x + abs(p[0]) * width)], [1.0]),
        "corner": terms(y, lambda p: [x, np.maximum(x - p[0] * width, 0)], [1.0]),
        "fading": terms(y, lambda p: [x, np.exp(-x / (abs(p[0]) * width + 1e-9 * x.max()))], [0.3]),
    }


def gains(y, x, **drivers):
    """Models in which drivers change the slope and not the zero, each alone and all together."""
    u, parts = scaled(x), {name: scaled(z) for name, z in drivers.items()}
    models = {f"gain by {name}": line(y, x, x * v) for name, v in parts.items()}
    both = "gains by " + " and ".join(parts)
    return models | {both: line(y, x, *(x * v for v in parts.values())), f"{both}, and square": line(y, x, u**2, *(x * v for v in parts.values()))}
