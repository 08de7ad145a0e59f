"""Formats of the twentieth set, from bytes to columns, and models that several of it share (the others are in reading.py, instruments.py, rigs.py, loggers.py, stations.py, housekeeping.py, benches.py, receivers.py, recorders.py, probes.py, sensors.py and monitors.py)."""

import io
import re

import numpy as np
import pandas as pd
from fitting import line, scaled
from monitors import bends_with
from reading import means
from rigs import since
from scipy.io import loadmat

DAY = 86400
YEAR = 365.25 * DAY
KILOYEAR = 1000 * YEAR
PARTS = ("cal", "trans", "test")
CLOCK = re.compile(r"\d+:\d\d:\d\d")


def absorbances(content, instrument, *nanometres):
    """What one spectrometer told of all samples at some wavelengths."""
    file = loadmat(io.BytesIO(content))
    spectra = np.vstack([file[f"X{part}{instrument}"] for part in PARTS])
    wavelengths = file["wv"][0].astype(int).tolist()
    return [spectra[:, wavelengths.index(one)] for one in nanometres]


def laboratory(content):
    """What the laboratory told of all samples."""
    file = loadmat(io.BytesIO(content))
    return np.concatenate([file[f"y{part}"][:, 0] for part in PARTS])


def porometer(content, *names):
    """Readings of a porometer with a lamp for fluorescence: seconds since the first, and columns by their name."""
    frame = pd.read_csv(io.BytesIO(content), skiprows=[0, 2])
    numbers = frame[list(names)].apply(pd.to_numeric)
    return numbers.assign(time_s=since(pd.to_timedelta(frame.Time).dt.total_seconds()))


def gas_exchange(content, every=5):
    """Curves of a leaf in a chamber, a run a curve, means of some readings: carbon dioxide inside of the leaf in ppm, light, and what the leaf takes up."""
    frame, parts = pd.read_csv(io.BytesIO(content)), []
    for run, curve in frame.groupby("CurveID"):
        told = {name: means(curve[column].to_numpy(), every) for name, column in (("inside_ppm", "Ci"), ("light_umol", "Qin"), ("uptake_umol", "A"))}
        parts.append(pd.DataFrame({"run": run, **told}))
    return pd.concat(parts, ignore_index=True)


def casts(content, laboratory, *names):
    """Water from the sea as one laboratory told it, means of what was taken at one time; seconds since the first."""
    frame = pd.read_excel(io.BytesIO(content))
    frame = frame[frame.PI == laboratory].dropna(subset=list(names))
    of_day = frame.Time.astype(str).str[-8:]
    when = pd.to_datetime(frame.Date) + pd.to_timedelta(of_day.where(of_day.str.fullmatch(CLOCK), "00:00:00"))
    told = frame[list(names)].apply(pd.to_numeric).groupby(when).mean().sort_index()
    return told.assign(time_s=since((told.index - told.index[0]).total_seconds())).reset_index(drop=True)


def ice(content):
    """Ages in thousand years and temperatures from ice, in K from that of today; ages without one are left out."""
    frame = pd.read_csv(io.BytesIO(content)).dropna()
    return frame.Age.to_numpy() / 1000, frame.Temperature.to_numpy()


def shells(content):
    """Ages in thousand years and heavy oxygen in shells of the deep sea, in per mille."""
    frame = pd.read_csv(io.BytesIO(content), skiprows=5, names=["age", "heavy", "error"], encoding="utf-8-sig")
    return frame.age.to_numpy(float), frame.heavy.to_numpy()


def by_day(content, *names):
    """Days of a table by their date; seconds since the first."""
    frame = pd.read_csv(io.BytesIO(content), parse_dates=["date"])
    return frame[list(names)].assign(time_s=since((frame.date - frame.date.iloc[0]).dt.total_seconds()))


def beach(content, *names):
    """Half hours of a beach; seconds since the first."""
    frame = pd.read_csv(io.BytesIO(content))
    when = pd.to_datetime(frame["index"], format="%m/%d/%Y %H:%M")
    return frame[list(names)].assign(time_s=since((when - when.iloc[0]).dt.total_seconds()))


def plate(content, *wells):
    """Optical density of some wells of a plate; seconds since the reader was started."""
    lines = [text.split("\t") for text in content.decode("latin1").splitlines()]
    head = next(cells for cells in lines if cells[0] == "Time")
    rows = [cells for cells in lines if CLOCK.fullmatch(cells[0])]
    seconds = [sum(int(part) * unit for part, unit in zip(cells[0].split(":"), (3600, 60, 1))) for cells in rows]
    return {"time_s": seconds, **{well: np.array([float(cells[head.index(well)]) for cells in rows]) for well in wells}}


def towers(content, *names):
    """Towers at the moments at which a satellite passed over them, in the order of these moments."""
    frame = pd.read_csv(io.BytesIO(content))
    frame = frame.dropna(subset=list(names))
    return frame.sort_values(["eco_time_utc", "ID"], kind="stable")


def of_drivers(y, x, **drivers):
    """A square and a cube, and each driver alone, bent, as a slope, and with a square."""
    u, models = scaled(x), bends_with(y, x)
    for name, z in drivers.items():
        v = scaled(z)
        models |= {name: line(y, x, v), f"{name}, bent": line(y, x, v, v**2), f"slope by {name}": line(y, x, v, u * v), f"square, and {name}": line(y, x, u**2, v)}
        models |= {f"square, and slope by {name}": line(y, x, u**2, v, u * v), f"all squares of {name}": line(y, x, u**2, v, u * v, v**2)}
    return models
