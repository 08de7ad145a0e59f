"""Reads files of the package grapa."""

import numpy as np
from durations import DAY
from formats.rows import numbered
from formats.text import csv


def sputtered_ions(content, *names):
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


def cell_kept_hot(content, least):
    """Power of a solar cell that is kept hot and in light, each half an hour; rows with less light than a number are left out."""
    frame = csv(content, sep=";", skiprows=3)
    parts = frame.Time.str.split(":", expand=True).astype(float)
    kept = frame.Illumination >= least
    return {"time_s": (parts @ [DAY, 3600, 60, 1])[kept], "power_mw_cm2": frame["Pmp [mW/cm^2]"][kept]}
