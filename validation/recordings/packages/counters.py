"""Formats of the twenty-third set, from bytes to columns (the others are in reading.py, instruments.py, rigs.py, loggers.py, stations.py, housekeeping.py, benches.py, receivers.py, recorders.py, probes.py, sensors.py, monitors.py, meters.py, dials.py and gauges.py)."""

import gzip
import io
import json
import lzma

import numpy as np
import pandas as pd
from fitting import line, moved, terms, tone, usual
from pickled import plain
from reading import array, csv, means, seconds
from rigs import multivu

DAY = 86400
METER = {"power_kw": "Global_active_power", "reactive_kvar": "Global_reactive_power", "voltage_v": "Voltage", "current_a": "Global_intensity"}


def house(content, begin, end, minutes):
    """What the meter of a house told between two dates, means over so many minutes; those that lack a number are left out."""
    frame = csv(lzma.decompress(content), na_values="?", nrows=120_000)
    when = pd.to_datetime(frame.Date + " " + frame.Time, format="%d/%m/%Y %H:%M:%S")
    frame = frame[(when >= begin) & (when < end)]
    return pd.DataFrame({name: means(frame[column], minutes) for name, column in METER.items()}).dropna()


def walls(content, begin, end, every):
    """Warmth at the north wall of a house and at an airport between two dates; seconds since the first row."""
    frame = csv(lzma.decompress(content), parse_dates=["date"])
    frame = frame[(frame.date >= begin) & (frame.date < end)].iloc[::every]
    return {"time_s": seconds(frame.date), "airport_degc": frame.T_out, "wall_degc": frame.T6}


def in_step(y, x, t):
    """Models of a thermometer beside another one that goes through the day ahead of it or behind it."""
    day = [*tone(t, DAY), *tone(t, DAY / 2)]
    at = lambda p: moved(x, t, p[0] * 3600)
    return {
        **usual(y, x, t, 3600),
        "shift ahead": terms(y, lambda p: [at(p)], [-0.5]),
        "day": line(y, x, *day),
        "day, and square": line(y, x, x**2, *day),
        "day, and drift": line(y, x, t, *day),
        "shift, and square": terms(y, lambda p: [at(p), at(p) ** 2], [-0.5]),
        "shift, and day": terms(y, lambda p: [at(p), *day], [-0.5]),
        "shift, day, and slope by it": terms(y, lambda p: [at(p), *day, *(at(p) * k for k in day[:2])], [-0.5]),
    }


def moments(content, every):
    """Rows of a magnetometer in which it has measured a moment, each so many."""
    return multivu(content).dropna(subset=["Moment (emu)"]).iloc[::every]


def sputtered(content, *names):
    """Counts of some ions while a layer is worn off, from 6 s on; names are those of its head."""
    lines = [text.rstrip("\t").split("\t") for text in content.decode("latin1").splitlines()]
    start = next(k for k, cells in enumerate(lines) if cells[0].startswith("Sputter"))
    table = np.array(lines[start + 1 :], float)
    kept = table[table[:, 0] >= 6]
    return [kept[:, lines[start - 2].index(name)] for name in names]


def capacitances(*contents):
    """Capacitance of a solar cell over the frequency, a file each warmth: runs from 1 on."""
    tables = []
    for content in contents:
        lines = content.decode("utf-8-sig").splitlines()
        start = next(k for k, text in enumerate(lines) if text.startswith("Frequency"))
        tables.append(np.array([text.split("\t")[:3] for text in lines[start + 1 :] if text.strip()], float))
    hertz, farad, kelvin = np.concatenate(tables).T
    return {"run": numbered(tables), "decades": np.log10(hertz).round(6), "cell_k": kelvin, "capacitance_nf": farad}


def kept_hot(content, least):
    """Power of a solar cell that is kept hot and in light, each half an hour; rows with less light than a number are left out."""
    frame = csv(content, sep=";", skiprows=3)
    parts = frame.Time.str.split(":", expand=True).astype(float)
    kept = frame.Illumination >= least
    return {"time_s": (parts @ [DAY, 3600, 60, 1])[kept], "power_mw_cm2": frame["Pmp [mW/cm^2]"][kept]}


def ferrite(content, material, least):
    """Angle by which the flux of a core is behind its field, over the flux: a run each warmth and frequency, rows with at least so many T."""
    measured = json.loads(content)[material]["measurements"]["complex_permeability"]["LEA_LK"]["measurement_data"]
    rows = [(k, one["frequency"] / 1000, flux, angle) for k, one in enumerate(measured, 1) for flux, angle in zip(one["flux_density"], one["mu_phi_deg"]) if flux >= least]
    return dict(zip(("run", "frequency_khz", "flux_t", "angle_deg"), zip(*rows)))


def road(content):
    """Nitrogen dioxide at a road and away from it, and the wind: means of the days that have all three; seconds since the first."""
    frame = csv(gzip.decompress(content), parse_dates=["date"]).set_index("date")[["no2", "bg.no2", "ws"]].resample("D").mean().dropna()
    return {"time_s": seconds(frame.index.to_series()), "background": frame["bg.no2"], "wind_m_s": frame.ws, "road": frame.no2}


def events(content, period):
    """How bright a part of a brain is in a scanner, a row each so many seconds, and whether something was shown: 1 then, else 0."""
    frame = csv(content)
    return {"time_s": np.arange(len(frame)) * period, "shown": (frame.events > 0).astype(int), "signal": frame.bold}


def evaporation(content, begin, end, every):
    """Warmest of each day and what grass would evaporate on it, from a year to before another, each so many days; seconds since the first."""
    frame = csv(content, sep=r"\s+").rename(columns={"Day": "day", "Month": "month", "Year": "year"})
    frame = frame[(frame.year >= begin) & (frame.year < end)].iloc[::every]
    return {"time_s": seconds(pd.to_datetime(frame[["year", "month", "day"]])), "warmest_degc": frame["Tmax(C)"], "evaporation_mm": frame["Et0(mm)"]}


def glow(content, samples, emission, *excitations):
    """How bright some samples glow in one colour while they react, under light of some colours: an array each, a row a sample."""
    table = array(content)[samples, emission]
    return [table[:, excitation] for excitation in excitations]


def radicals(*contents, every):
    """Spectra of a spectrometer that goes through a field, by the step of the field."""
    return [np.asarray(plain(content)["DAT"], float)[::every] for content in contents]


def numbered(tables):
    """The run of each row of tables that lie one behind the other, from 1 on."""
    return np.repeat(np.arange(1, len(tables) + 1), [len(table) for table in tables])


def in_runs(run, t, what):
    """What is made of each run by itself: of its rows, and of its time from 0 on."""
    out = np.empty(len(t))
    for number in np.unique(run):
        rows = run == number
        out[rows] = what(rows, t[rows] - t[rows][0])
    return out
