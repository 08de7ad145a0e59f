"""Well logs (LAS)."""

import pandas as pd


def well_log(content):
    """The curves of a well log (LAS), rows that have a number in all of them."""
    lines = content.decode("latin1").splitlines()
    curves, data = (next(k for k, line in enumerate(lines) if line.startswith(mark)) + 1 for mark in ("~C", "~A"))
    ends = next(k for k in range(curves, data) if lines[k].startswith("~"))
    names = [line.split(".")[0].strip() for line in lines[curves:ends] if line.strip() and line[0] != "#"]
    frame = pd.DataFrame([[float(v) for v in line.split()] for line in lines[data:] if line.strip()], columns=names)
    return frame[~frame.isin([-99999, -999.25]).any(axis=1)]
