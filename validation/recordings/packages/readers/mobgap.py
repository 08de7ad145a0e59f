"""Reads files of the package mobgap."""

import numpy as np
from formats.matlab import variables


def paces(told):
    """Where strides begin and end in s, and how long they are in m, of one way to see them."""
    bouts = [bout for bout in np.atleast_1d(told.MicroWB) if np.size(bout.Stride_Length)]
    rows = np.vstack([np.column_stack([np.atleast_2d(bout.Stride_InitialContacts), np.atleast_1d(bout.Stride_Length)]) for bout in bouts] or [np.empty((0, 3))])
    rows = rows[np.isfinite(rows).all(axis=1)]
    counted = len(rows) and np.median(rows[:, 1] - rows[:, 0]) > 20
    return rows / [100, 100, 1] if counted else rows


def strides(*contents, apart):
    """Lengths of strides by cameras and by what was worn, where both begin and end them within so many seconds."""
    found = []
    for content in contents:
        data = variables(content, squeeze_me=True, struct_as_record=False)["data"]
        for walk in walks(data):
            seen, worn = paces(walk.Standards.Stereophoto), paces(walk.Standards.INDIP)
            for stride in worn if len(seen) else []:
                off = np.abs(seen[:, :2] - stride[:2]).max(axis=1)
                if off.min() < apart:
                    found.append([seen[off.argmin(), 2], stride[2]])
    return dict(zip(("cameras_m", "worn_m"), np.array(found).T))


def walks(data):
    """Trials of a person that both cameras and worn sensors saw."""
    tests = [getattr(time, test) for time in struct_parts(data) for test in time._fieldnames]
    for trial in (trial for test in tests for trial in struct_parts(test)):
        standards = getattr(trial, "Standards", None)
        if hasattr(standards, "Stereophoto") and hasattr(standards, "INDIP"):
            yield trial


def struct_parts(struct):
    """What a struct of MATLAB holds, without the names."""
    return [getattr(struct, name) for name in struct._fieldnames]
