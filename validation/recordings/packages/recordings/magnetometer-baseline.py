"""Baseline of the vertical component of a magnetometer in a tunnel, against a theodolite about once a week for 14 months: what a hand measured less what the instrument read."""

import io

import pandas as pd
from formats.clock import seconds
from models.cycles import tone
from models.fitting import line

HAND_BUILT = "drift"


def rows(content):
    lines = content.decode().splitlines()
    start = next(k for k, text in enumerate(lines) if text.startswith("Epoch"))
    d = pd.read_csv(io.StringIO("\n".join(lines[start + 2 :])), header=None)
    d = d[d[14].notna() & (d[14].abs() < 9e4)]
    return {"time_s": seconds(pd.to_datetime(d[0])), "baseline_nt": d[14]}


def models(c):
    y, t = c["baseline_nt"], c["time_s"]
    year = tone(t, 365.25 * 86400)
    return y, {"constant": line(y), HAND_BUILT: line(y, t), "yearly cycle": line(y, *year), "drift and cycle": line(y, t, *year)}
