"""Formats of the twenty-sixth set, from bytes to columns (the others are in reading.py, instruments.py, rigs.py, loggers.py, stations.py, housekeeping.py, benches.py, receivers.py, recorders.py, probes.py, sensors.py, monitors.py, meters.py, dials.py, gauges.py, counters.py, pickups.py and scales.py)."""

import csv as tables
import io
import json
import zipfile

import numpy as np
import pickled
from fitting import lag, line, scaled, terms
from gauges import HOUR
from numpy.lib import format as arrays
from reading import csv


def columns(content, rows=None, **names):
    """Columns of a CSV by the names that they are to have, its first rows where their number is told."""
    frame = csv(content).iloc[:rows]
    return {name: frame[column] for name, column in names.items()}


def pairs(content, step=None, rows=None, **names):
    """Columns of pairs that lie in one table, a pair a row: each is told by the name of the pair and a letter; seconds since the first where a step is told."""
    frame = csv(content).set_index("SampleID")
    told = {name: np.array(frame.loc[pair, letter].split(), float)[:rows] for name, (pair, letter) in names.items()}
    clock = {} if step is None else {"time_s": np.arange(len(next(iter(told.values())))) * step}
    return {**clock, **told}


def melted(fast, slow, lowest, highest):
    """What a sample takes up as it is warmed fast, and as it was at the same warmth when it was warmed slowly; seconds since the lowest warmth."""
    fast, slow = json.loads(fast), json.loads(slow)
    warmth, taken = np.array(fast["T"]), np.array(fast["latentdata"])
    kept = (warmth > lowest) & (warmth < highest)
    told = {"time_s": (warmth[kept] - warmth[kept][0]) / fast["rate"] * 60, "slow_j_gk": np.interp(warmth[kept], slow["T"], slow["latentdata"])}
    return {name: np.round(values, 6) for name, values in {**told, "fast_j_gk": taken[kept]}.items()}


def optics(content):
    """A tree of tables of refractive indices: an array that holds one pickled object (NumPy) in an archive of arrays."""
    with zipfile.ZipFile(io.BytesIO(content)) as parts:
        told = io.BytesIO(parts.read("database.npy"))
    arrays.read_magic(told)
    arrays.read_array_header_1_0(told)
    return pickled.plain(told.read()).item()


def warm_crystal(content, shelf, book, cold, hot, shortest):
    """A refractive index beyond a wavelength in um at several warmths, each a run, beside the one when cold at the same wavelength; pages are named by degC."""
    pages, found = optics(content)[shelf][book], []
    table = lambda page: (np.array(pages[page]["DATA"]["wavelengths"]), np.array(pages[page]["DATA"]["index"]).real)
    at, index = table(cold)
    for run, page in enumerate(hot, 1):
        where, seen = table(page)
        kept = where > shortest
        warmth = float(page.split("-")[-1].removesuffix("C"))
        found += [[run, warmth, *both] for both in zip(np.interp(where[kept], at, index), seen[kept])]
    return dict(zip(("run", "warmth_degc", "cold", "hot"), np.array(found).T))


def spectra(content, times):
    """Wavelengths in nm, and of each the reflectance of so many times a person, person after person: a CSV whose head names the times R1, R2 and so on."""
    cells = list(tables.reader(io.StringIO(content.decode("latin1"))))
    begin, head = next((k, line) for k, line in enumerate(cells) if line and line[0].startswith("Wavelength"))
    columns = [0, *(k for k, name in enumerate(head) if name.startswith("R"))]
    values = np.array([[line[k] for k in columns] for line in cells[begin + 1 :]], float)
    return values[:, 0], values[:, 1:].reshape(len(values), -1, times)


def skins(content, times=3, **wavelengths):
    """Reflectance of skin near some wavelengths, a row for each time that a person was seen; a person is a run."""
    told, seen = spectra(content, times)
    people = seen.shape[1]
    near = lambda one: seen[np.argmin(np.abs(told - one))].ravel()
    return {"run": np.repeat(np.arange(people) + 1, times), **{name: near(one) for name, one in wavelengths.items()}}


def of_skin(y, x, people, **colour):
    """Models of the light that comes back from skin at one wavelength, by that at another and that of one further colour (each N)."""
    [(name, of_colour)] = colour.items()
    return {
        f"slope by {name} alone": line(y, x, scaled(x) * scaled(of_colour)),
        "product of powers": terms(y, lambda p: [x ** p[0] * of_colour ** p[1]], [1.0, 0.5]),
        "number": line(y, x, people),
    }


def skin_twice(content, times, *wavelengths):
    """Reflectance of skin near some wavelengths the first and the second time that a person was seen; a person is a run."""
    told, seen = spectra(content, times)
    near = [np.argmin(np.abs(told - one)) for one in wavelengths]
    both, people = seen[near].transpose(1, 0, 2), seen.shape[1]
    run = np.repeat(np.arange(people) + 1, len(near))
    return {"run": run, "nm": np.tile(told[near], people), "first": both[:, :, 0].ravel(), "second": both[:, :, 1].ravel()}


def roofs(first, second, begin, end, least):
    """What the solar cells of two houses give in the hours between two days since the first, while both give so much; seconds since the first hour."""
    here, there = (csv(content)["Solar Generation [W/kW]"].to_numpy()[begin * 24 : end * 24] for content in (first, second))
    kept = (here > least) & (there > least)
    hours = np.flatnonzero(kept)
    return {"time_s": (hours - hours[0]) * HOUR, "first_w_kw": here[kept], "second_w_kw": there[kept]}


def cells(content, first, second):
    """Charge of one cell beside that of another in the same cycle."""
    frame = csv(content)
    one, other = (frame[frame.battery_id == name].set_index("cycle").capacity for name in (first, second))
    both = one.index.intersection(other.index)
    return {"first_ah": one[both], "second_ah": other[both]}


def behind(y, x, t, unit):
    """Models of what comes later than its cause, by a lag that begins at one unit in s: alone, and beside a bend, a drift, a shift and another lag."""
    late = lambda p: lag(x, t, abs(p) * unit)
    return {
        "lag, and square": terms(y, lambda p: [late(p[0]), late(p[0]) ** 2], [1.0]),
        "lag, and drift": terms(y, lambda p: [late(p[0]), t], [1.0]),
        "line, and lag": terms(y, lambda p: [x, late(p[0])], [1.0]),
        "lag of a lag": terms(y, lambda p: [lag(late(p[0]), t, abs(p[1]) * unit)], [0.5, 0.5]),
        "two lags": terms(y, lambda p: [late(p[0]), late(p[1])], [0.5, 2.0]),
    }


def switched(y, x, t, places):
    """Models of a zero and a slope that are others from some time on: that of the places, as parts of the whole, at which the line fits best."""
    from_there = [(t > t[0] + place * (t[-1] - t[0])).astype(float) for place in places]
    best = lambda of: min(of, key=lambda term: np.std(y - line(y, x, term)(np.ones(len(y), bool))))
    zero, slope = best(from_there), best([x * step for step in from_there])
    others = {"step": zero, "drift": t, "slope that drifts": x * t}
    return {
        "step": line(y, x, zero),
        "slope that changes": line(y, x, slope),
        **{f"slope that changes, and {name}": line(y, x, slope, term) for name, term in others.items()},
    }
