"""Formats of the tenth set, from bytes to columns (the others are in reading.py and instruments.py), and models that several of its recordings have in common."""

import io

import numpy as np
import pandas as pd
from fitting import line, terms
from reading import csv


def since(values):
    """Values less the first."""
    values = np.asarray(values, float)
    return values - values[0]


def summed(rates, seconds):
    """What something that goes at these rates has come to by each row, straight between rows."""
    return np.append(0, np.cumsum(np.diff(seconds) * (rates[1:] + rates[:-1]) / 2))


def charged(amp, seconds):
    """Ah that a current has brought by each row."""
    return summed(amp, seconds) / 3600


def multivu(content):
    """The data of a file of a magnetometer or of a cryostat, below its header."""
    return csv(content[content.index(b"[Data]") + 7 :], encoding="latin1")


def tagged(content):
    """Columns of numbers of a table whose first column holds the settings of the measurement."""
    return csv(content, sep="\t", encoding="latin1").iloc[:, 1:].apply(pd.to_numeric, errors="coerce")


def aquadopp(content, every=4):
    """Rows of a current meter while it is moored, each so many, by the number of its column, from one on; seconds since the first."""
    frame = csv(content, sep=r"\s+", header=None)
    frame.columns += 1
    frame = frame.iloc[150:9900]
    at = pd.to_datetime({"year": frame[3], "month": frame[1], "day": frame[2], "hour": frame[4], "minute": frame[5], "second": frame[6]})
    return frame.assign(time_s=(at - at.iloc[0]).dt.total_seconds()).iloc[::every]


def pull(content):
    """A specimen that is pulled, each 0.06 s from 6 s on until shortly before it breaks: seconds, position in mm, load in kN, strain in per cent."""
    frame = csv(content).iloc[600:12400:6, [0, 6, 7, 8]]
    frame.columns = ["time_s", "position_mm", "load_kn", "strain_pct"]
    return frame.assign(time_s=since(frame.time_s))


def cycles(content, share=0.9):
    """Cycles of a fatigue test without the first three and the last tenth: seconds, the largest position in mm, load in kN and strain in per cent."""
    frame = csv(content)
    frame = frame.iloc[3 : int(len(frame) * share), [3, 5, 7, 9]]
    frame.columns = ["time_s", "position_mm", "load_kn", "strain_pct"]
    return frame.assign(time_s=since(frame.time_s))


def balance(content):
    """A thermobalance: seconds, weight in mg, temperature of the sample."""
    return pd.read_csv(io.BytesIO(content), sep="\t", skiprows=2, header=None, encoding="latin1", names=["row", "sample_c", "time_s", "weight_mg", "program_c"])


def plates(content):
    """Forces and moments of two force plates, 2000 times a second: Fx, Fy, Fz, Mx, My, Mz of the first, then of the second."""
    return csv(content, header=None, skip_blank_lines=True).to_numpy(float)


def bends(y, x):
    """Models of a curve `y` over `x` that comes to another slope."""
    scale = float(np.ptp(x)) / 20
    soft = lambda p: np.logaddexp(0, (x - p[0]) / abs(p[1]))
    return {
        "line": line(y, x),
        "square": line(y, x, x**2),
        "cubic": line(y, x, x**2, x**3),
        "soft bend": terms(y, lambda p: [x, soft(p)], [float(np.quantile(x, 0.25)), scale]),
        "saturation": terms(y, lambda p: [x, np.tanh((x - p[0]) / abs(p[1]))], [float(np.quantile(x, 0.25)), 2 * scale]),
    }


def loops(y, x, width, shift):
    """Models of a hysteresis loop `y` over `x`: the field at which it turns over is another on the way up and down."""
    against = np.sign(np.gradient(x))
    step = lambda p: np.tanh((x - p[1] * against) / abs(p[0]))
    return {
        "line": line(y, x),
        "cubic": line(y, x, x**2, x**3),
        "direction": line(y, x, against),
        "saturation": terms(y, lambda p: [x, np.tanh(x / abs(p[0]))], [width]),
        "direction, and saturation": terms(y, lambda p: [x, against, np.tanh(x / abs(p[0]))], [width]),
        "saturation at a field by direction": terms(y, lambda p: [x, step(p)], [width, shift]),
    }
