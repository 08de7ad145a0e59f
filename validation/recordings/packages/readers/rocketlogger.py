"""Reads files of the package rocketlogger, and holds models that its recordings share."""

import struct

import numpy as np
from formats.rows import means
from models.bends import usual_and_bends
from models.fitting import line, terms
from models.jumps import soft_step

BINARY = (3, 4)


def logger(content):
    """Readings of a logger for current and voltage by the name of the channel, in its units, 1000 a second."""
    told = struct.unpack_from("<4x2H2IQH6x16xI2H", content)
    begin, rows, blocks, _, _, comment, flags, inputs = told[1:]
    at, names, scales = 56 + comment, [], []
    for k in range(flags + inputs):
        unit, scale, width, _, name = struct.unpack_from("<Ii2H16s", content, at + 28 * k)
        if unit not in BINARY:
            names.append(name.rstrip(b"\0").decode())
            scales.append(10.0**scale)
            assert width == 4, f"a number of {name} has {width} bytes"
    row = np.dtype([("flags", "<u4", (-(-flags // 32),)), ("inputs", "<i4", (len(names),))])
    block = np.dtype([("clocks", "<i8", (4,)), ("rows", row, (rows,))])
    read = np.frombuffer(content, block, blocks, begin)["rows"]["inputs"].reshape(-1, len(names))
    return {name: read[:, k] * scale for k, (name, scale) in enumerate(zip(names, scales))}


def side_by_side(content, first, second, unit, labels):
    """Two inputs of the logger, means of 20 readings, in a unit; seconds since the first."""
    read = logger(content)
    first, second = (means(read[name], 20) / unit for name in (first, second))
    return {"time_s": np.arange(len(first)) / 50, **dict(zip(labels, (first, second)))}


def alike_models(y, x, t):
    """What is tried for two inputs of one logger: bends, drifts, what fades from the start on, what differs between small and large of either sign."""
    fading = lambda p: np.exp(-t / (abs(p) * 10 + 0.01))
    return {
        **usual_and_bends(y, x, t, 1),
        "drift, and its square": line(y, x, t, t**2),
        "square, and drift": line(y, x, x**2, t),
        "part that fades": terms(y, lambda p: [x, fading(p[0])], [0.1]),
        "slope that drifts": line(y, x, t, x * t),
        "size": line(y, x, np.abs(x)),
        "size, and drift": line(y, x, np.abs(x), t),
        "direction": line(y, x, np.sign(np.gradient(np.convolve(x, np.ones(101) / 101, "same")))),
        "step": terms(y, lambda p: [x, soft_step(t, p[0] * 10, 0.1)], [3.5]),
    }
