"""Formats of the nineteenth set, from bytes to columns, and models that several of it share (the others are in reading.py, instruments.py, rigs.py, loggers.py, stations.py, housekeeping.py, benches.py, receivers.py, recorders.py, probes.py and sensors.py)."""

import bz2
import io
import tarfile

import numpy as np
import pandas as pd
from fitting import line, scaled, terms
from reading import means
from rigs import since

DAY = 86400
MICRO = 1e6
# columns of a table of daily numbers that has fixed places: rotation of the sun, number of spots, flux at the mean distance of the sun
ROTATION, SPOTS, FLUX = slice(11, 15), slice(89, 92), slice(93, 98)
ROTATION_DAYS = 27


def x_rays(content, *names):
    """Readings of a monitor of the sun's X-rays by the name of the detector, and seconds since the year 2000; readings are in millionths of a W/m2."""
    import netCDF4  # the other readers do without it

    with netCDF4.Dataset("memory", memory=content) as file:
        read = {name: np.ma.filled(file[name][:].astype(float), np.nan) for name in ("time", *names)}
    return {name: values if name == "time" else values * MICRO for name, values in read.items()}


def two_detectors(content, first, second, labels):
    """Two detectors of one monitor, means of two readings, a row each two seconds."""
    read = x_rays(content, first, second)
    first, second = (means(read[name], 2) for name in (first, second))
    return {"time_s": means(since(read["time"]), 2).round(3), **dict(zip(labels, (first, second)))}


def air_station(content, *names):
    """Hours of a station for the air with a number in each of the columns; seconds since the first hour of the table."""
    frame = pd.read_csv(io.BytesIO(content), usecols=["Time", *names], parse_dates=["Time"])
    frame = frame.assign(time_s=(frame.Time - frame.Time.iloc[0]).dt.total_seconds())
    return frame.dropna()


def craters(content, glass, first, second):
    """Counts of two isotopes while a laser drills into a glass, in thousands a second: a run a crater, with the clock of the day and the seconds that it has been drilled."""
    frame = pd.read_excel(io.BytesIO(content), sheet_name="Buffer")
    frame = frame[frame.SampleLabel.str.startswith(f"{glass}_-_")]
    start, parts = pd.Timestamp(frame.timestamp.min()), []
    for when, shot in frame.groupby("timestamp"):
        drilled = shot.iloc[slice(*drilling(shot["29Si"].to_numpy()))]
        seconds = drilled.Time.to_numpy() / 1000
        told = {"run": len(parts) + 1, "time_s": (pd.Timestamp(when) - start).total_seconds() + seconds, "drilled_s": since(seconds)}
        parts.append(pd.DataFrame({**told, "first_kcps": drilled[first].to_numpy() / 1000, "second_kcps": drilled[second].to_numpy() / 1000}))
    frame = pd.concat(parts, ignore_index=True)
    return frame.assign(time_s=since(frame.time_s).round(3), drilled_s=frame.drilled_s.round(3))


def drilling(silicon, least=8e5):
    """First and last row in which a laser drills, less two rows at either end in which it only begins or ends."""
    rows = np.flatnonzero(silicon > least)
    return rows[0] + 2, rows[-1] - 1


def pulled(content, every=4):
    """A specimen that is pulled: seconds, way of the crosshead in mm, load in kN and way of the extensometer in mm, means of some readings, until the load first falls by more than a twentieth of a kN from one to the next."""
    lines = content.decode("utf-8-sig").splitlines()[8:]
    table = np.array([[float(cell.replace(",", ".")) for cell in text.split("\t")] for text in lines if text.strip()])
    last = int(np.flatnonzero(np.diff(table[:, 1]) < -0.05)[0]) - 5
    way, load, seconds, gauge = (means(column[:last], every) for column in table.T)
    return {"time_s": seconds.round(4), "way_mm": np.abs(way), "load_kn": load, "gauge_mm": gauge}


def sun_by_rotation(content):
    """Number of sunspots and radio flux of the sun in sfu as means of a rotation of 27 days; seconds since the first."""
    days = [text for text in content.decode("ascii").split("END OBSERVED")[0].splitlines() if text[:4].isdigit()]
    frame = pd.DataFrame([[float(text[place]) for place in (ROTATION, SPOTS, FLUX)] for text in days], columns=["rotation", "spots", "flux_sfu"])
    grouped = frame.groupby("rotation")
    whole = grouped.mean()[grouped.size() == ROTATION_DAYS].reset_index()
    return whole.assign(time_s=since(whole.rotation) * ROTATION_DAYS * DAY)


def soil(content, *places):
    """Columns of a table of soil samples by their place."""
    with np.load(io.BytesIO(content), allow_pickle=False) as file:
        return file["dataset_data"][:, places].T


def star(content, name, worst=0.2):
    """A star in two colours at the times at which both cameras saw it well, in magnitudes; seconds since the first."""
    with tarfile.open(fileobj=io.BytesIO(bz2.decompress(content))) as file:
        red, blue = (pd.read_csv(file.extractfile(f"lc_{name}.{colour}.mjd"), sep=r"\s+", skiprows=3, names=["day", "mag", "error"]) for colour in "RB")
    both = red.merge(blue, on="day", suffixes=("_red", "_blue"))
    both = both[(both.error_red < worst) & (both.error_blue < worst)]
    return both.assign(time_s=(since(both.day) * DAY).round(1))


def bends_with(y, x, **others):
    """A square and a cube, alone and with each of some other terms, after the line."""
    u = scaled(x)
    models = {"line": line(y, x), "square": line(y, x, u**2), "cube": line(y, x, u**2, u**3)}
    for name, term in others.items():
        models |= {name: line(y, x, term), f"{name}, and slope by it": line(y, x, term, x * term), f"square, and {name}": line(y, x, u**2, term)}
    return models


def corner(y, x, at):
    """A line that turns into another, over a width that is fitted."""
    return terms(y, lambda p: [x, abs(p[1]) * np.logaddexp(0, (x - p[0]) / abs(p[1]))], [at, 0.5])
