"""Formats of the twenty-eighth set, from bytes to columns (the others are in reading.py, instruments.py, rigs.py, loggers.py, stations.py, housekeeping.py, benches.py, receivers.py, recorders.py, probes.py, sensors.py, monitors.py, meters.py, dials.py, gauges.py, counters.py, pickups.py, scales.py, levels.py and needles.py)."""

import bz2
import io

import numpy as np
import pandas as pd
from fitting import line, scaled, tone
from gauges import DAY, HOUR
from reading import csv, means, seconds


def shot(content):
    """Seconds and volts of a gauge, two columns without a head."""
    return np.loadtxt(io.BytesIO(content)).T


def shots(*contents, first, last, every):
    """What the gauge of a machine that compresses gas told at two shots, each so many rows of a stretch: seconds since its first row, and volts of either."""
    (time, one), (_, other) = (shot(content)[:, first:last:every] for content in contents)
    return {"time_s": np.round(time - time[0], 6), "first_v": one, "second_v": other}


def slow_shots(*contents, begin, rows):
    """Means of so many rows of shots, from some second on: seconds since the first mean, and volts of each shot."""
    tables = [shot(content) for content in contents]
    time, *volts = (means(values, rows) for values in (tables[0][0], *(told for _, told in tables)))
    kept = time > begin
    return {"time_s": np.round(time[kept] - time[kept][0], 6), **{f"{name}_v": np.round(told[kept], 9) for name, told in zip(("first", "second"), volts)}}


def stretched(content, every):
    """A strip that is pulled until it breaks, each so many rows up to the greatest force: seconds, stroke in mm, force in N. Rows are those that begin with a number, in quotes."""
    lines = [text.replace('"', "").split(",") for text in content.decode("cp932", "replace").splitlines()]
    rows = np.array([[float(cell) for cell in cells[:3]] for cells in lines if len(cells) == 4 and cells[0][:1].isdigit()])
    time, force, stroke = rows[: rows[:, 1].argmax() : every].T
    return {"time_s": time, "stroke_mm": stroke, "force_n": force}


def sea(content, every):
    """How high the waves at a buoy are, and how long they last, each so many rows; seconds since the first."""
    frame = csv(content, sep=";", skipinitialspace=True).iloc[::every]
    height, period = (frame.iloc[:, k] for k in (1, 2))
    return {"time_s": seconds(pd.to_datetime(frame.iloc[:, 0], format="%Y-%m-%d-%H")), "height_m": height, "period_s": period}


def of_book(content, **names):
    """Columns of a packed table by the names that they are to have."""
    frame = csv(bz2.decompress(content))
    return {name: frame[column] for name, column in names.items()}


def bank(content, **names):
    """Columns of a table of soil by the names that they are to have, rows without a gap."""
    frame = csv(content).dropna()
    return {name: frame[column] for name, column in names.items()}


def town(content, first, hours, **names):
    """Columns of a year of hours by the names that they are to have, so many hours from one on; seconds since the first."""
    frame = csv(content, sep=r"\s+").iloc[first : first + hours]
    return {"time_s": np.arange(len(frame)) * HOUR, **{name: frame[column] for name, column in names.items()}}


def cars(content):
    """Cars in the order of their years: their weight, the year, and how far they go with a gallon."""
    frame = csv(content, sep=r"\s+")
    return {"weight_lb": frame.weight, "year": frame.year + 1900, "miles_gallon": frame.mpg}


def riders(content, first, rows):
    """Bicycles that were lent to those who come now and then and to those who are on a list, so many hours from one on; seconds since the first."""
    frame = csv(content).iloc[first : first + rows]
    hours = (frame.day - frame.day.iloc[0]) * 24 + frame.hr - frame.hr.iloc[0]
    return {"time_s": hours * HOUR, "casual": frame.casual, "registered": frame.registered}


def by_day(y, x, t):
    """Models of what goes with the time of day, three waves, beside a bend, a drift and slopes."""
    u, w, day = scaled(x), scaled(t), [part for wave in (1, 2, 3) for part in tone(t, DAY / wave)]
    return {
        "one wave a day": line(y, x, *day[:2]),
        "two waves a day": line(y, x, *day[:4]),
        "day": line(y, x, *day),
        "day, and square": line(y, x, u**2, *day),
        "day, and cube": line(y, x, u**2, u**3, *day),
        "day, and drift": line(y, x, w, *day),
        "day, square, and drift": line(y, x, u**2, w, *day),
        "day, and slope by it": line(y, x, *day, *(u * part for part in day)),
        "day, and slope that drifts": line(y, x, w, u * w, *day),
        "day alone": line(y, *day),
    }


def two_drivers(y, x, **drivers):
    """Models with two drivers, by their names, beside one another."""
    u, (one, other) = scaled(x), (scaled(values) for values in drivers.values())
    both = " and ".join(drivers)
    return {
        both: line(y, x, one, other),
        f"{both}, and square": line(y, x, u**2, one, other),
        f"{both}, slope by the first": line(y, x, one, other, u * one),
        f"{both}, slope by the second": line(y, x, one, other, u * other),
        f"{both}, all slopes": line(y, x, one, other, u * one, u * other),
        f"{both}, bent": line(y, x, one, other, one**2, other**2),
    }
