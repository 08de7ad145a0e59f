"""Reads files of the package pycnv."""

import numpy as np


def bottles(*contents, **names):
    """What a probe told where bottles were closed in the sea, one cast after the other, by the places of the columns behind the time."""
    found = []
    for cast, content in enumerate(contents, 1):
        closed = [line.split() for line in content.decode("latin1").splitlines() if line.endswith("(avg)")]
        found += [[cast, *(float(line[4 + place]) for place in names.values())] for line in closed]
    return dict(zip(["run", *names], np.array(found).T))
