"""Formats of the eighteenth set, from bytes to columns, and models that several of it share (the others are in reading.py, instruments.py, rigs.py, loggers.py, stations.py, housekeeping.py, benches.py, receivers.py, recorders.py and probes.py)."""

import io
import struct

import numpy as np
import pandas as pd
from fitting import line, terms
from reading import means
from recorders import usual_and_bends

BINARY = (3, 4)
DAY = 86400


def logger(content):
    """Readings of a logger for current and voltage by the name of the channel, in its units, 1000 a second."""
    told = struct.unpack_from("<4x2H2IQH6x16xI2H", content)
    begin, rows, blocks, _, _, comment, flags, inputs = told[1:]
    at, names, scales = 56 + comment, [], []
    for k in range(flags + inputs):
        unit, scale, width, _, name = struct.unpack_from("<Ii2H16s", content, at + 28 * k)
        if unit not in BINARY:
            names.append(name.rstrip(b"\0").decode())
            scales.append(10.0**scale)
            assert width == 4, f"a number of {name} has {width} bytes"
    row = np.dtype([("flags", "<u4", (-(-flags // 32),)), ("inputs", "<i4", (len(names),))])
    block = np.dtype([("clocks", "<i8", (4,)), ("rows", row, (rows,))])
    read = np.frombuffer(content, block, blocks, begin)["rows"]["inputs"].reshape(-1, len(names))
    return {name: read[:, k] * scale for k, (name, scale) in enumerate(zip(names, scales))}


def side_by_side(content, first, second, unit, labels):
    """Two inputs of the logger, means of 20 readings, in a unit; seconds since the first."""
    read = logger(content)
    first, second = (means(read[name], 20) / unit for name in (first, second))
    return {"time_s": np.arange(len(first)) / 50, **dict(zip(labels, (first, second)))}


def switched(x, at, width):
    """0 well below a value, 1 well above it."""
    return 0.5 + 0.5 * np.tanh((x - at) / (2 * width))


def inputs_alike(y, x, t):
    """What is tried for two inputs of one logger: bends, drifts, what fades from the start on, what differs between small and large of either sign."""
    fading = lambda p: np.exp(-t / (abs(p) * 10 + 0.01))
    return {
        **usual_and_bends(y, x, t, 1),
        "drift, and its square": line(y, x, t, t**2),
        "square, and drift": line(y, x, x**2, t),
        "part that fades": terms(y, lambda p: [x, fading(p[0])], [0.1]),
        "slope that drifts": line(y, x, t, x * t),
        "size": line(y, x, np.abs(x)),
        "size, and drift": line(y, x, np.abs(x), t),
        "direction": line(y, x, np.sign(np.gradient(np.convolve(x, np.ones(101) / 101, "same")))),
        "step": terms(y, lambda p: [x, switched(t, p[0] * 10, 0.1)], [3.5]),
    }


def turbine(content):
    """Ten minutes of a wind turbine by the name of its sensor, means of 10 readings, 2.5 rows a second; seconds since the first."""
    import netCDF4  # the other readers do without it

    with netCDF4.Dataset("memory", memory=content) as file:
        names = [str(name).strip() for name in file["attribute_names"][:]]
        table = np.ma.filled(file["block0000/data"][:].astype(float), np.nan)
    read = {name: means(values, 10) for name, values in zip(names, table.T)}
    return {"time_s": np.arange(len(read[names[0]])) * 0.4, **read}


def weather(content):
    """Rows of a station beside mirrors with a number in every column, and seconds since the first."""
    return sheet(content, "Weather").dropna()


def sheet(content, name):
    """A sheet of a workbook whose first column is the time, in rows that have one, and seconds since the first."""
    frame = pd.read_excel(io.BytesIO(content), sheet_name=name)
    frame = frame.loc[:, ~frame.columns.str.startswith("Unnamed")].dropna(subset=["Time"])
    return frame.assign(time_s=(frame.Time - frame.Time.iloc[0]).dt.total_seconds())


def mirrors(contents):
    """Reflectance of mirrors beside that of the first, which lies flat, campaign by campaign: a run a mirror, with the seconds of its campaign and its tilt in degrees, which its name tells."""
    runs = []
    for content in contents:
        told = sheet(content, "Reflectance_Average")
        flat, *others = [name for name in told.columns if "_T" in name]
        for name in others:
            tilt = float(name.rpartition("_T")[2])
            runs.append(pd.DataFrame({"run": len(runs) + 1, "time_s": told.time_s, "flat_pct": told[flat], "mirror_pct": told[name], "tilt_deg": tilt}).dropna())
    return pd.concat(runs, ignore_index=True)


def overflow(content):
    """Water that flows over a sill in the sea in Sv, means of three days; a run lasts from one gap of more than five days to the next."""
    import netCDF4  # the other readers do without it

    with netCDF4.Dataset("memory", memory=content) as file:
        frame = pd.DataFrame({name: np.ma.filled(file[name][:].astype(float), np.nan).ravel() for name in ("TIME", "FBC_tr")}).dropna()
    seconds = (frame.TIME - frame.TIME.iloc[0]) * DAY
    numbers = (seconds.diff() > 5 * DAY).cumsum() + 1
    parts = [pd.DataFrame({"run": run, "time_s": means(seconds[rows], 3), "flow_sv": means(frame.FBC_tr[rows], 3).round(4)}) for run, rows in frame.groupby(numbers).groups.items()]
    return pd.concat(parts, ignore_index=True)


def cells(content, *names):
    """Cells that pass a camera, one by one, by the names of what it saw; seconds since the first, 2000 pictures a second; of those in one picture the first."""
    import netCDF4  # the other readers do without it

    with netCDF4.Dataset("memory", memory=content) as file:
        frame = pd.DataFrame({name: np.ma.filled(file["events"][name][:].astype(float), np.nan) for name in ("frame", *names)})
    frame = frame.drop_duplicates("frame")
    return frame.assign(time_s=(frame.frame - frame.frame.iloc[0]) / 2000)
