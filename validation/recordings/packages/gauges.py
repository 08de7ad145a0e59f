"""Formats of the twenty-second set, from bytes to columns, and models that several of it share (the others are in reading.py, instruments.py, rigs.py, loggers.py, stations.py, housekeeping.py, benches.py, receivers.py, recorders.py, probes.py, sensors.py, monitors.py, meters.py and dials.py)."""

import gzip
import io

import numpy as np
import pandas as pd
from fitting import lag, line, moved, scaled, terms, usual
from reading import seconds
from rigs import since

DAY = 86400
HOUR = 3600
FOOT = 0.3048
SPRING = {"water_degc": ("00010", 1), "stage_m": ("00065", FOOT), "flow_m3_s": ("00060", FOOT**3), "oxygen_mg_l": ("00300", 1)}


def film(measured, planned, millimetres, every):
    """Dose over a film and over the plan of it, each so many points in both directions: doses in Gy, and the place along the film."""
    measured, planned = (np.loadtxt(io.BytesIO(content), delimiter=",", comments="#")[::every, ::every] for content in (measured, planned))
    place = np.indices(measured.shape)[0] * every * millimetres
    return {"place_mm": place.ravel(), "planned_gy": planned.ravel(), "film_gy": measured.ravel()}


def spring(content, *names, every=1):
    """Daily means of a spring's gauge, days that have all that is asked for; seconds since the first."""
    frame = pd.read_csv(io.BytesIO(content), index_col=0, parse_dates=True)
    parameters = [column.split("_") for column in frame.columns]
    mean = {parts[3]: place for place, parts in enumerate(parameters) if parts[4].startswith("00003")}
    told = pd.DataFrame({name: frame.iloc[:, mean[SPRING[name][0]]] * SPRING[name][1] for name in names}).dropna().iloc[::every]
    return told.assign(time_s=seconds(told.index.to_series())).reset_index(drop=True)


def thermometers(content, first, second, begin, end, every=1):
    """What thermometers at two places told each day, in degC."""
    frame = pd.read_csv(io.BytesIO(content), encoding="utf-8-sig", index_col=0, parse_dates=True).loc[begin:end].iloc[::every]
    return {"time_s": seconds(frame.index.to_series()), "there_degc": (frame[first] - 32) / 1.8, "here_degc": (frame[second] - 32) / 1.8}


def hours(content, begin, end):
    """Hours of a weather station between two dates: warmth, sun, and humidity; seconds since the first."""
    frame = pd.read_csv(io.BytesIO(gzip.decompress(content)), index_col=0, parse_dates=True).loc[begin:end].dropna()
    return {"time_s": seconds(frame.index.to_series()), "air_degc": frame.temp, "sun_w_m2": frame["glob"], "humidity_percent": frame.hum}


def bands(content, period, *wavenumbers):
    """How much light of some wavenumbers a broth takes away, a spectrum each so many seconds."""
    table = np.loadtxt(io.BytesIO(content), delimiter=",")
    told = {f"band_{one}": table[1:, np.argmin(np.abs(table[0] - one))] for one in wavenumbers}
    return {"time_s": np.arange(len(table) - 1) * period, **told}


def two_fields(first, second, apart, worst):
    """Magnitudes of one star in two fields of a camera, of exposures that follow each other so soon; seconds since the first."""
    first, second = (pd.read_csv(io.BytesIO(content), sep=r"\s+", header=None, usecols=[0, 1, 2], names=["day", "mag", "error"]) for content in (first, second))
    first, second = (frame[frame.error < worst].sort_values("day") for frame in (first, second))
    both = pd.merge_asof(second, first, on="day", direction="nearest", tolerance=apart / DAY, suffixes=("_2", "_1")).dropna()
    return {"time_s": (since(both.day) * DAY).round(1), "first_mag": both.mag_1, "second_mag": both.mag_2}


def darkness(content, *exposures):
    """Counts of all pixels in the dark, for some exposures in s."""
    table = np.loadtxt(io.BytesIO(content), delimiter=",")
    return [table[1:][table[1:, 0] == exposure][0, 1:] for exposure in exposures]


def polarised(plus, minus, widest, every):
    """Neutrons that a sample scatters with their spin along the field and against it: part of the way that is across the field, as a square, and its length in 1/nm."""
    across, along, up, _ = np.loadtxt(io.BytesIO(plus), skiprows=2).T
    down = np.loadtxt(io.BytesIO(minus), skiprows=2)[:, 2]
    way = np.hypot(across, along)
    kept = np.flatnonzero((way < widest) & (up > 0) & (down > 0))[::every]
    return {"across": ((along / way) ** 2)[kept], "way_1_nm": 10 * way[kept], "against": down[kept], "along": up[kept]}


def grating(content, *pixels):
    """Counts of some pixels while a grating turns, a row a step of it."""
    with np.load(io.BytesIO(content), allow_pickle=False) as file:
        return file["probe"][:, pixels].T


def later(y, x, t, unit, late, apart=0.0):
    """What is tried where one thing comes after another by a time that is another at the end; search begins at so many units, and at so many more from one end to the other."""
    shifted = lambda p: moved(x, t, p[0] * unit)
    then = lambda p: np.interp(t - (p[0] + p[1] * (t / t[-1] - 0.5)) * unit, t, x)
    return {
        **usual(y, x, t, unit),
        "shift from there": terms(y, lambda p: [shifted(p)], [late]),
        "shift, and square": terms(y, lambda p: [shifted(p), shifted(p) ** 2], [late]),
        "shift, and drift": terms(y, lambda p: [shifted(p), t], [late]),
        "shift, and lag": terms(y, lambda p: [lag(shifted(p), t, abs(p[1]) * unit)], [late, 0.3]),
        "shift that changes": terms(y, lambda p: [then(p)], [late, apart]),
        "shift that changes, and square": terms(y, lambda p: [then(p), then(p) ** 2], [late, apart]),
        "shift that changes, and slope that drifts": terms(y, lambda p: [then(p), t * then(p)], [late, apart]),
    }


def switches(y, x, t, at):
    """What is tried where something was switched at a time: a step of the zero, of the slope, and of both, with a bend and a drift."""
    step, u, v = (t > at) * 1.0, scaled(x), scaled(t)
    return {
        "step": line(y, x, step),
        "slope from then on": line(y, x, x * step),
        "step, and slope": line(y, x, step, x * step),
        "step, and square": line(y, x, u**2, step),
        "step, and drift": line(y, x, step, v),
        "step, and drift after it": line(y, x, step, step * v, step * v**2),
    }
