"""Formats of the sixteenth set, from bytes to columns, and the models that several of it share (the other formats are in reading.py, instruments.py, rigs.py, loggers.py, stations.py, housekeeping.py, benches.py and receivers.py)."""

import io
import re
import zipfile

import numpy as np
import pandas as pd
from fitting import lag, line, moved, scaled, terms, usual
from reading import csv, netcdf
from rigs import since

SEAL = {name: name for name in ("depth", "light", "temperature")}
TRACE = re.compile(r"ExampleData/RES-(\d)_(-\d+)_DBM_TEMP_([\d.]+)\.S2P")
NEAR = 15


def hubs(content):
    """Counts of the channels of one or more hubs for sensors on a body, by the address of the hub and the number of its channel."""
    import netCDF4  # the other readers do without it

    with netCDF4.Dataset("memory", memory=content) as file:
        raw = {address: hub["raw"] for address, hub in file.groups.items()}
        return {f"{address}/{name}": one[:][:, 0].astype(float) for address, hub in raw.items() for name, one in hub.variables.items() if name != "nSeq"}


def clock(values, hertz):
    """Seconds of readings that come so many times a second."""
    return np.arange(len(values)) / hertz


def engine(content, begin):
    """Rows of the monitor of an aircraft's engine from one on, by the names before the unit; seconds since the first, as many rows a second as the whole recording has."""
    lines = content.decode("latin1").splitlines()
    head = next(k for k, text in enumerate(lines) if text.startswith("TIME,"))
    frame = csv("\n".join(text.rstrip(",") for text in lines[head:]).encode(), index_col=False)
    when = pd.to_timedelta(frame.TIME)
    step = (when.iloc[-1] - when.iloc[0]).total_seconds() / (len(frame) - 1)
    frame.columns = [name.split(";")[0] for name in frame.columns]
    frame = frame.iloc[begin:]
    return frame.assign(time_s=(np.arange(len(frame)) * step).round(3))


def sinking_glider(content):
    """Rows of a glider: seconds, pressure in bar, pitch in rad, volume that it has pumped in cm3, density of the water in kg/m3."""
    told = np.load(io.BytesIO(content), allow_pickle=False)[:5]
    frame = pd.DataFrame(told.T, columns=["time_s", "pressure_bar", "pitch_rad", "pumped_cm3", "density"])
    return frame.assign(time_s=since(frame.time_s).round(3))


def seal(content, begin, end):
    """Rows of a recorder on a seal between two hours of its clock, with a number in every column, a row each five seconds."""
    frame = netcdf(content, {**SEAL, "date_time": "date_time"})
    frame = frame[(frame.date_time >= begin * 3600) & (frame.date_time < end * 3600)].dropna()
    return frame.assign(time_s=since(frame.date_time))


def traces(content, resonator, powers):
    """Traces of a resonator in the order in which they were measured: seconds, power in dBm, temperature in K, frequency in Hz, transmission."""
    with zipfile.ZipFile(io.BytesIO(content)) as file:
        found = [(TRACE.fullmatch(one.filename), one) for one in file.infolist()]
        found = [(told, one) for told, one in found if told and int(told[1]) == resonator and int(told[2]) in powers]
        found = sorted(found, key=lambda pair: (pair[1].date_time, int(pair[0][2])))
        start = pd.Timestamp(*found[0][1].date_time)
        for told, one in found:
            hertz, real, imaginary = np.loadtxt(io.BytesIO(file.read(one)), skiprows=1).T
            yield (pd.Timestamp(*one.date_time) - start).total_seconds(), int(told[2]), float(told[3]), hertz, np.hypot(real, imaginary)


def resonance(hertz, passed):
    """Frequency at which a resonator lets least through: the foot of a parabola through the square of the transmission around its smallest."""
    foot = int(np.argmin(passed))
    near = slice(max(foot - NEAR, 0), foot + NEAR + 1)
    square, slope, _ = np.polyfit(hertz[near] - hertz[foot], passed[near] ** 2, 2)
    return hertz[foot] - slope / 2 / square


def usual_and_lags(y, x, t, unit):
    """What is tried where one thing is behind another: beside the usual models a lag with more, and a lag of a lag; lags begin at half a unit, in s."""
    late = lambda p: lag(x, t, abs(p) * unit)
    return {
        **usual(y, x, t, unit),
        "line and lag": terms(y, lambda p: [x, late(p[0])], [0.5]),
        "lag, and drift": terms(y, lambda p: [late(p[0]), t], [0.5]),
        "lag, and square": terms(y, lambda p: [late(p[0]), late(p[0]) ** 2], [0.5]),
        "lag, and shift": terms(y, lambda p: [moved(late(p[0]), t, p[1] * unit)], [0.5, 0.1]),
        "two lags": terms(y, lambda p: [lag(late(p[0]), t, abs(p[1]) * unit)], [3.0, 0.3]),
    }


def usual_and_bends(y, x, t, unit):
    """What is tried where a law is bent: beside the usual models a cube, alone and with a drift, with a shift, with a lag, and more powers."""
    u = scaled(x)
    cube, fifth = ([u**k for k in range(1, n)] for n in (4, 6))
    return {
        **usual(y, x, t, unit),
        "cube": line(y, *cube),
        "cube, and drift": line(y, *cube, t),
        "cube that is shifted": terms(y, lambda p: [moved(term, t, p[0] * unit) for term in cube], [0.3]),
        "cube, and lag": terms(y, lambda p: [*cube, lag(u, t, abs(p[0]) * unit)], [1.0]),
        "fifth power": line(y, *fifth),
        "fifth power that is shifted": terms(y, lambda p: [moved(term, t, p[0] * unit) for term in fifth], [0.3]),
        "fifth power, and lag": terms(y, lambda p: [*fifth, lag(u, t, abs(p[0]) * unit)], [1.0]),
        "ninth power": line(y, *(u**k for k in range(1, 10))),
    }
