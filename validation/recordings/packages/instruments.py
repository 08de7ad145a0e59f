"""Formats of the ninth set, from bytes to columns (the others are in reading.py), and models that several of its recordings have in common."""

import struct

import numpy as np
import pandas as pd
from fitting import lag, line, moved, terms, usual
from reading import csv, seconds


def cement(content, first, every=4):
    """Heat flow of eight channels of a calorimeter in mW, each so many rows, from a time in s on."""
    frame = csv(content, skiprows=[1, 2])
    frame = frame[frame.Zeit >= first].iloc[::every]
    return frame.assign(time_s=frame.Zeit - frame.Zeit.iloc[0])


def thermostat(content, first, every):
    """Room and bath of a calorimeter, each so many rows, from a time in s on."""
    lines = content.decode("utf-8").splitlines()
    start = next(k for k, line in enumerate(lines) if line.startswith('"Time"')) + 1
    cells = [line.split(",")[:4] for line in lines[start:] if line.count(",") >= 6]
    frame = pd.DataFrame(cells, columns=["time", "room", "bath", "heat"]).apply(pd.to_numeric, errors="coerce").dropna()
    frame = frame[(frame.time > first) & (frame.time.diff().fillna(1) > 0)].iloc[::every]
    return frame.assign(time_s=frame.time - frame.time.iloc[0])


def bird_logger(content):
    """Depth and temperature of a logger on a bird, with seconds since its first row."""
    frame = csv(content).dropna()
    when = pd.to_datetime(frame.date + " " + frame.time, format="mixed")
    frame = frame.assign(time_s=seconds(when))
    return frame[frame.time_s.diff().fillna(1) > 0]


def out_of_water(content, rows=3000):
    """So many rows at which the bird is calm, not under water: 61 rows scatter by less than 0.08 m, and this one is less than 1 m deep."""
    frame = bird_logger(content)
    frame = frame[(frame.pressure.rolling(61, center=True).std() < 0.08) & (frame.pressure < 1)]
    frame = frame.iloc[:: max(1, len(frame) // rows)]
    return frame.assign(time_s=frame.time_s - frame.time_s.iloc[0])


def zero_models(y, x, t):
    """Models of a zero `y` by the temperature `x` of its logger and the time `t`."""
    late = lambda p: lag(x, t, abs(p) * 600)
    return {
        "constant": line(y),
        "drift": line(y, t),
        "temperature": line(y, x),
        "temperature, bent": line(y, x, x**2),
        "temperature, and drift": line(y, x, t),
        "temperature, bent, and drift": line(y, x, x**2, t),
        "temperature, and late temperature": terms(y, lambda p: [x, late(p[0])], [1.0]),
        "temperature, late temperature, and drift": terms(y, lambda p: [x, late(p[0]), t], [1.0]),
    }


def weather_station(content, name):
    """Rows of one of the weather stations of a table, by their time."""
    frame = csv(content, sep=";")
    frame = frame[frame.Vlinder == name]
    return frame.assign(when=pd.to_datetime(frame.Datum + " " + frame["Tijd (UTC)"])).set_index("when")


def station_pair(content, first, second, column, every=3):
    """One column of two weather stations, `_1` and `_2`, each so many rows, with seconds since the first."""
    both = weather_station(content, first)[[column]].join(weather_station(content, second)[[column]], lsuffix="_1", rsuffix="_2")
    both = both.iloc[::every].dropna()
    return (both.index - both.index[0]).total_seconds().to_numpy(), both.iloc[:, 0].to_numpy(), both.iloc[:, 1].to_numpy()


def gauges(first, second, column, rows=3500):
    """The same column of two daily tables of a river, by days that both have, with seconds since the first."""
    frames = [csv(content, index_col=0, parse_dates=True).iloc[:, [column]] for content in (first, second)]
    both = frames[0].join(frames[1], lsuffix="_1", rsuffix="_2").dropna().iloc[:rows]
    return (both.index - both.index[0]).total_seconds().to_numpy(), both.iloc[:, 0].to_numpy(float), both.iloc[:, 1].to_numpy(float)


def river_models(y, x, t, day=86400):
    """Models of a gauge `y` by that upstream, `x`, at times `t`; water comes later, and may come slowly."""
    shifted = lambda p: moved(x, t, p * day)
    return {
        **usual(y, x, t, day),
        "shift, and lag": terms(y, lambda p: [lag(shifted(p[0]), t, abs(p[1]) * day)], [0.5, 0.5]),
        "shift, and square": terms(y, lambda p: [shifted(p[0]), shifted(p[0]) ** 2], [0.5]),
        "line and lag": terms(y, lambda p: [x, lag(x, t, abs(p[0]) * day)], [1.0]),
    }


TDMS_KINDS = {1: "i1", 2: "<i2", 3: "<i4", 4: "<i8", 5: "u1", 6: "<u2", 7: "<u4", 8: "<u8", 9: "<f4", 10: "<f8", 0x21: "u1"}


def tdms(content):
    """Channels of numbers of a TDMS file, by the last part of their names, up to the first channel of text."""
    at, found, order, known = 0, {}, [], {}

    def text(at):
        size = struct.unpack_from("<I", content, at)[0]
        return content[at + 4 : at + 4 + size].decode("latin1"), at + 4 + size

    while content[at : at + 4] == b"TDSm":
        flags, _, size, raw = struct.unpack_from("<IIQQ", content, at + 4)
        begin, end, here = at + 28 + raw, min(len(content), at + 28 + size), at + 28
        if flags & 2:
            order = [] if flags & 4 else order
            objects, here = struct.unpack_from("<I", content, here)[0], here + 4
            for _ in range(objects):
                path, here = text(here)
                index, here = struct.unpack_from("<I", content, here)[0], here + 4
                if index not in (0, 0xFFFFFFFF):
                    known[path] = struct.unpack_from("<IIQ", content, here)[::2]
                    here += index - 4
                if index != 0xFFFFFFFF and path not in order:
                    order.append(path)
                properties, here = struct.unpack_from("<I", content, here)[0], here + 4
                for _ in range(properties):
                    _, here = text(here)
                    kind, here = struct.unpack_from("<I", content, here)[0], here + 4
                    here = text(here)[1] if kind == 0x20 else here + (16 if kind == 0x44 else np.dtype(TDMS_KINDS[kind]).itemsize)
        while flags & 8 and order and begin < end:
            for path in order:
                kind, count = known[path]
                if kind not in TDMS_KINDS:
                    return found
                values = np.frombuffer(content, TDMS_KINDS[kind], count, begin)
                name = path.split("/")[-1].strip("'")
                begin, found[name] = begin + values.nbytes, np.append(found.get(name, np.empty(0)), values)
        at = end
    return found


def plant(content):
    """Rows of a solar plant, five minutes each, that have a number in every column, with seconds since the first."""
    frame = csv(content, index_col=0, parse_dates=True).dropna()
    return frame.assign(time_s=(frame.index - frame.index[0]).total_seconds())
