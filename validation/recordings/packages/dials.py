"""Formats of the twenty-first set, from bytes to columns, and models that several of it share (the others are in reading.py, instruments.py, rigs.py, loggers.py, stations.py, housekeeping.py, benches.py, receivers.py, recorders.py, probes.py, sensors.py, monitors.py and meters.py)."""

import io

import numpy as np
import pandas as pd
from fitting import line, scaled, tone, usual
from reading import means
from rigs import since
from scipy.io import loadmat

DAY = 86400
AIR = "air"


def spectrum(content, column):
    """A column of numbers of a spectrometer's file by its name, over the shift of the light in 1/cm; pixels without a wavelength are left out."""
    lines = [text.split(";") for text in content.decode("latin1").splitlines()]
    first = next(k for k, cells in enumerate(lines) if cells[0] == "Pixel")
    head, table = lines[first], [[cell.strip().replace(",", ".") for cell in cells] for cells in lines[first + 1 :]]
    frame = pd.DataFrame(table).iloc[:, : len(head)].set_axis(head, axis=1)
    told = frame[["Wavelength", "Raman Shift", column]].apply(pd.to_numeric, errors="coerce").dropna()
    return told["Raman Shift"].to_numpy(), told[column].to_numpy()


def powers(contents, milliwatts, weakest, between, every):
    """Spectra of one sample under a laser of several powers, a run a spectrum, over the mean of those at the least power, which come first."""
    parts, least = [], []
    for run, (content, power) in enumerate(zip(contents, milliwatts, strict=True), 1):
        shift, counts = spectrum(content, "Dark Subtracted #1")
        counts = counts[(shift > between[0]) & (shift < between[1])][::every]
        if run <= weakest:
            least.append(counts)
        else:
            parts.append(pd.DataFrame({"run": run - weakest, "weak_counts": np.mean(least, axis=0), "strong_counts": counts, "power_mw": power}))
    return pd.concat(parts, ignore_index=True)


def mueller(content, between):
    """Wavelengths in nm and the sixteen elements of a Mueller matrix, row by row, of a file with a line each wavelength."""
    table = np.loadtxt(io.BytesIO(content), comments=";")
    table = table[(table[:, 0] > between[0]) & (table[:, 0] < between[1])]
    return table[:, 0], table[:, 1:].T


def zones(content):
    """Readings of an ellipsometer by the zone in which its polarisers stood: angle of the light in deg, delta and psi in deg; zone 0 is the mean of all four."""
    names = ["nm", "bandwidth", "angle", "delta", "psi", "zone"]
    frame = pd.read_csv(io.BytesIO(content), sep="\t", skiprows=2, header=None, encoding="latin1").iloc[:, :6].set_axis(names, axis=1)
    return {zone: rows.reset_index(drop=True) for zone, rows in frame.groupby("zone")}


def pushed(content, electrodes, hertz, every):
    """A muscle that pushes: seconds, how loud its electrodes are in uV as a mean of their root mean squares over some readings, and the force as a mean of these, in per cent of the most."""
    table = loadmat(io.BytesIO(content))["Data"][0, 0]
    rows = len(table) // every * every
    loud = table[:rows, :electrodes] - table[:, :electrodes].mean(axis=0)
    loud = np.sqrt((loud.reshape(-1, every, electrodes) ** 2).mean(axis=1)).mean(axis=1)
    return {"time_s": (np.arange(len(loud)) * every / hertz).round(4), "loud_uv": loud.round(4), "force_pct": means(table[:rows, -1], every).round(4)}


def shaken_star(content):
    """Light of a star in a telescope that rolls, without the rows in which its thrusters fire: seconds, light over its usual one, and the way of the star over the camera in pixels."""
    frame = pd.read_csv(io.BytesIO(content), skipinitialspace=True, index_col=False)
    frame = frame[frame["Thrusters On"] == 0]
    return {"time_s": (since(frame.iloc[:, 0]) * DAY).round(1), "light": frame["Raw Flux"], "way_px": frame.arclength}


def scans(content, notes, measurement, temperature):
    """Scans of all wells of a plate by one measurement, a column a well, and what the notes tell of the wells at a temperature, by the well."""
    told = pd.read_csv(io.BytesIO(notes))
    told = told[told.Temp == temperature].set_index("Well")
    lines = content.decode("latin1").splitlines()
    first = next(k for k, text in enumerate(lines) if text.startswith("Well\t"))
    last = next(k for k, text in enumerate(lines) if k > first and not text.strip())
    frame = pd.read_csv(io.StringIO("\n".join(lines[first:last])), sep="\t")
    frame = frame[["Well", f"Meas{measurement}:WavelengthExc", f"Meas{measurement}:Result"]].set_axis(["well", "nm", "counts"], axis=1).dropna()
    return frame.pivot(index="nm", columns="well", values="counts"), told


def solar_plant(content, plant, every):
    """Hours of day at one plant, each so many: seconds since the first, and the columns by their name."""
    frame = pd.read_csv(io.BytesIO(content), parse_dates=["date"])
    frame = frame[frame.randid == plant].dropna().iloc[::every]
    return frame.assign(time_s=(frame.date - frame.date.iloc[0]).dt.total_seconds())


def chromatograph(content, first, second):
    """Areas of two peaks in thousands, of air, an hour a row, where both are there; seconds since the first."""
    lines = content.decode("latin1").splitlines()
    names = [name for name in lines[1].split() if name != "-"]
    rows = [text.split() for text in lines[3:] if text.strip()]
    rows = [cells for cells in rows if cells[3] == AIR]
    when = pd.to_datetime([cells[0] + cells[1] for cells in rows], format="%y%m%d%H%M")
    areas = {name: np.array([float(cells[4 + names.index(name)]) for cells in rows]) / 1000 for name in (first, second)}
    frame = pd.DataFrame({"time_s": (when - when[0]).total_seconds(), **areas})
    return frame[(frame[first] > 0) & (frame[second] > 0)]


def steps(contents, speeds, between):
    """Troughs of the force under a foot between its two peaks, a run a walker, and the speed in m/s, a row a step."""
    speeds, parts = np.load(io.BytesIO(speeds), allow_pickle=False), []
    for run, content in enumerate(contents):
        forces = np.load(io.BytesIO(content), allow_pickle=False)
        parts.append(pd.DataFrame({"run": run + 1, "speed_m_s": speeds[:, run], "trough": forces[:, slice(*between)].min(axis=1)}))
    return pd.concat(parts, ignore_index=True)


def leaves(content):
    """Readings of leaves in a chamber that had come to rest, a run a leaf: what they take up, how open their pores are, and how dry the air is for them."""
    frame = pd.read_csv(io.BytesIO(content), encoding="utf-8-sig").sort_values("CurveID", kind="stable")
    return {"run": frame.CurveID + 1, "uptake_umol": frame.A, "deficit_kpa": frame.VPDleaf, "conductance_mol": frame.gsw}


def waters(content):
    """Sea waters of a laboratory: temperature, pressure of carbon dioxide that was computed from the other two, and that which was measured."""
    frame = pd.read_csv(io.BytesIO(content), comment="#")
    return {"water_degc": frame.Temp, "computed_uatm": frame.CO2SYS_fCO2, "measured_uatm": frame.fCO2}


def ages(y, x, t):
    """What is tried where one gas in air is told over another: a bend, a clock, and slopes that go with the time; last with the day."""
    u, v = scaled(x), scaled(t)
    day, step = tone(t, DAY), (t > t[-1] / 2) * 1.0
    return {
        **usual(y, x, t, 3600),
        "step": line(y, x, step),
        "slope and step": line(y, x, step, x * step),
        "slope that drifts": line(y, x, v, u * v),
        "slope that drifts alone": line(y, x, u * v),
        "drift, and its square": line(y, x, v, v**2),
        "slope that drifts, square of the time": line(y, x, v, u * v, v**2, u * v**2),
        "slope that drifts, and square": line(y, x, u**2, v, u * v),
        "day": line(y, x, *day),
        "slope that drifts, and day": line(y, x, v, u * v, *day),
    }
