"""Reads a file of the package pydicom: twelve leads of a heart, in uV, 1000 rows a second, in the format DICOM with the little end first."""

import struct

import numpy as np
from models.drifts import usual_shifts_and_drifts
from models.drivers import of_drivers
from models.fitting import line, scaled, terms
from models.lags import moved

LONG = (b"OB", b"OW", b"OF", b"SQ", b"UT", b"UN")
BEFORE, SEQUENCE, ITEMS = 132, b"SQ", 0xFFFE
NAME, STEP, DATA = (0x0008, 0x0104), (0x003A, 0x0210), (0x5400, 0x1010)
RATE_HZ = 1000


def elements(content):
    """Tags and values of a file in their order, those inside of sequences among them."""
    at = BEFORE
    while at < len(content):
        tag = struct.unpack_from("<HH", content, at)
        kind, long = content[at + 4 : at + 6], content[at + 4 : at + 6] in LONG
        if tag[0] == ITEMS:
            at += 8
            continue
        (length,) = struct.unpack_from("<I" if long else "<H", content, at + (8 if long else 6))
        at += 12 if long else 8
        if kind != SEQUENCE:
            yield tag, content[at : at + length]
            at += length


def leads(content, every, **wanted):
    """Leads by the columns that they are to be, one row in so many of the first that are stored; seconds since the first row."""
    names, steps = [], []
    for tag, value in elements(content):
        if tag == NAME and value.startswith(b"Lead"):
            names.append(value.split()[1].decode())
        elif tag == STEP:
            steps.append(float(value))
        elif tag == DATA:
            break
    told = np.frombuffer(value, "<i2").reshape(-1, len(names))[::every] * steps
    columns = {column: told[:, names.index(name)] for column, name in wanted.items()}
    return {"time_s": np.arange(len(told)) * every / RATE_HZ, **columns}


def lead_models(y, x, z, t):
    """Models of a lead `y` over a second `x` beside a third `z`, the clock in hundredths of a second."""
    u, v, w = scaled(x), scaled(z), scaled(t)
    at, late = lambda p: moved(x, t, p[0] * 0.01), lambda p: moved(v, t, p[0] * 0.01)
    return {
        **usual_shifts_and_drifts(y, x, t, 0.01),
        **of_drivers(y, x, third=z),
        "third, and drift": line(y, x, v, w),
        "third, and shift": terms(y, lambda p: [at(p), v], [-0.3]),
        "third that is shifted": terms(y, lambda p: [x, late(p)], [0.3]),
        "third that is shifted, bent": terms(y, lambda p: [x, late(p), late(p) ** 2], [0.3]),
        "third that is shifted, and square": terms(y, lambda p: [x, u**2, late(p)], [0.3]),
        "third that is shifted, slope by it": terms(y, lambda p: [x, late(p), u * late(p)], [0.3]),
        "both that are shifted": terms(y, lambda p: [at(p), moved(v, t, p[1] * 0.01)], [-0.3, 0.3]),
    }
