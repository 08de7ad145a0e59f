"""Formats of the twenty-fourth set, from bytes to columns (the others are in reading.py, instruments.py, rigs.py, loggers.py, stations.py, housekeeping.py, benches.py, receivers.py, recorders.py, probes.py, sensors.py, monitors.py, meters.py, dials.py, gauges.py and counters.py)."""

import io
import struct

import numpy as np
import pandas as pd
from fitting import line, moved, terms, usual
from reading import csv, seconds
from rigs import since
from scipy.io import loadmat

# what a step of the press's converters is, as those who ran it wrote it down
SLIP_UM, SHEAR_MPA, LAYER_UM = 0.076472, 1.597778959e-3, 0.11017176


def basin(content, **names):
    """Channels of a wave basin by the names that they are to have; seconds since the first row."""
    file = loadmat(io.BytesIO(content), squeeze_me=True)
    frame = pd.DataFrame(file["data"], columns=file["chan_names"])
    return {"time_s": elapsed(frame.Time), **{name: frame[channel] for name, channel in names.items()}}


def towed(content, **names):
    """Channels of a towing tank, which are variables of their own, by the names that they are to have; seconds since the first row."""
    file = loadmat(io.BytesIO(content), squeeze_me=True)
    return {"time_s": elapsed(file["Time"]), **{name: file[channel] for name, channel in names.items()}}


def elapsed(times):
    """Seconds since the first of some, to 0.1 ms."""
    return since(times).round(4)


def press(content, beside, first, last, every):
    """Each so many rows of a press that shears rock: seconds since the first, slip, and beside it shear stress or thickness of the layer, each from a zero of its own."""
    rows, columns = struct.unpack(">ii", content[20:28])
    table = np.frombuffer(content, ">f4", rows * columns, len(content) - 4 * rows * columns).reshape(columns, rows).astype(float)
    _, slip, shear, layer, _ = table[:, first:last:every]
    told = {"shear_mpa": shear * SHEAR_MPA, "layer_um": layer * LAYER_UM}
    return {"time_s": elapsed(np.cumsum(table[0] / 10000)[first:last:every]), "slip_um": slip * SLIP_UM, beside: told[beside]}


def dryer(content, first, last):
    """Batches of a dryer from one to another."""
    frame = csv(content)
    return frame[frame.batch_id.between(first, last)]


def cooled(content, first, last, before):
    """Batches of a dryer from some rows before its jacket is cooled, as if a row were a minute: the batch, its clock, and how warm jacket and product are."""
    frame = dryer(content, first, last)
    starts = frame[frame.JacketTemperatureSP <= 0].groupby("batch_id").ClockTime.min()
    kept = frame[frame.ClockTime >= frame.batch_id.map(starts) - before]
    return {"run": kept.batch_id, "time_s": kept.ClockTime * 60, "jacket_degc": kept.JacketTemperature, "product_degc": kept.DryerTemp}


def foot(markers, sensors, side):
    """How fast a foot pitches by its markers, 100 times a second, and how fast a gyroscope on the shoe says that it pitches and twists, between two of its rows; all in deg/s."""
    seen, worn = csv(markers, header=[0, 1], index_col=0), csv(sensors, header=[0, 1], index_col=0)
    t, clock = seen.index.to_numpy() / 100, worn.index.to_numpy() / 204.8
    along = (seen[f"{side[0].upper()}_TOE"] - seen[f"{side[0].upper()}_FCC"]).to_numpy()
    pitch = np.degrees(np.arctan2(along[:, 2], np.hypot(along[:, 0], along[:, 1])))
    gyro = {name: np.interp(t, clock, worn[(f"{side}_sensor", axis)]) for name, axis in (("twist", "gyr_z"), ("gyro", "gyr_y"))}
    return {"time_s": t, "markers": -np.gradient(pitch, t), **gyro}


def wrist(content, every):
    """How warm a wrist sensor is, each so many rows; seconds since the first."""
    frame = csv(content, skiprows=100, header=None).iloc[::every]
    return {"time_s": seconds(pd.to_datetime(frame[0], format="%Y-%m-%d %H:%M:%S:%f")), "sensor_degc": frame[6]}


def ranges(content):
    """How far some radios are from a robot, by what it receives and by where it is, in the order of time; seconds since the first."""
    file = loadmat(io.BytesIO(content), squeeze_me=True)
    radios = {int(number): (east, north) for number, east, north in file["TL"]}
    at, _, number, told = file["TD"][np.unique(file["TD"][:, 0], return_index=True)[1]].T
    east, north = (np.interp(at, file["GT"][:, 0], file["GT"][:, k]) for k in (1, 2))
    places = np.array([radios[int(k)] for k in number])
    return {"time_s": elapsed(at), "apart_m": np.hypot(east - places[:, 0], north - places[:, 1]), "radio_m": told}


def geophones(content, rows, hertz, **stations):
    """The first rows of the vertical channels of some stations, from miniSEED of floating numbers, by the names that they are to have."""
    at, found = 0, {}
    while at < len(content):
        many, begin = struct.unpack_from(">H", content, at + 30)[0], struct.unpack_from(">H", content, at + 44)[0]
        if content[at + 15 : at + 18] == b"DPZ":
            found.setdefault(content[at + 8 : at + 13].decode().strip(), []).append(np.frombuffer(content, ">f4", many, at + begin))
        at += 1 << content[at + 54]
    return {"time_s": np.arange(rows) / hertz, **{name: np.concatenate(found[station])[:rows].astype(float) for name, station in stations.items()}}


def half_hours(content):
    """What a country's solar cells gave, each half an hour; seconds since the first."""
    frame = csv(content, parse_dates=["datetime_gmt"])
    return {"time_s": seconds(frame.datetime_gmt), "solar": frame.solar_gen}


def clocks(y, x, t, unit, **others):
    """What is tried first, and a shift beside a bend, a drift and other terms, either way."""
    at = lambda p: moved(x, t, p[0] * unit)
    models = {
        **usual(y, x, t, unit),
        "shift ahead": terms(y, lambda p: [at(p)], [-0.5]),
        "shift, and square": terms(y, lambda p: [at(p), at(p) ** 2], [-0.5]),
        "shift, and drift": terms(y, lambda p: [at(p), t], [-0.5]),
    }
    for name, term in others.items():
        models |= {name: line(y, x, term), f"shift, and {name}": terms(y, lambda p, term=term: [at(p), term], [-0.5])}
    return models
