"""Reads files of the package hysom, and holds models that its recordings share."""

import pandas as pd
from formats.clock import seconds
from formats.text import csv
from models.fitting import line, scaled, terms
from models.lags import behind, lag, moved, usual_and_shifts


def storm(rows, events, number):
    """Flow and turbidity of a river during one event of a list, where both have numbers; seconds since the first row."""
    frame, told = csv(rows).dropna(), csv(events).iloc[number]
    at = pd.to_datetime(frame.datetime, utc=True)
    kept = (at >= pd.to_datetime(told.start, utc=True)) & (at <= pd.to_datetime(told.end, utc=True))
    return {"time_s": seconds(at[kept]), "flow_m3_s": frame.Qcms[kept], "turbidity_fnu": frame.turb[kept]}


def turbidity_models(c):
    """Turbidity over flow, and their models: what comes early or late, what is washed out, what bends, and what drifts."""
    y, x, t = c["turbidity_fnu"], c["flow_m3_s"], c["time_s"]
    u, w, hour = scaled(x), scaled(t), 3600
    return y, {
        **usual_and_shifts(y, x, t, 4 * hour),
        "cube": line(y, x, u**2, u**3),
        "drift, and slope that drifts": line(y, x, w, u * w),
        "square, and drift": line(y, x, u**2, w),
        "square, drift, and slope that drifts": line(y, x, u**2, w, u * w),
        **behind(y, x, t, 3 * hour),
        "line, lag, and square": terms(y, lambda p: [x, u**2, lag(x, t, abs(p[0]) * 3 * hour)], [1.0]),
        "line, lag, and drift": terms(y, lambda p: [x, w, lag(x, t, abs(p[0]) * 3 * hour)], [1.0]),
        "line, lag, and slope that drifts": terms(y, lambda p: [x, w, u * w, lag(x, t, abs(p[0]) * 3 * hour)], [1.0]),
        "line, lag, and shift": terms(y, lambda p: [moved(x, t, p[1] * hour), lag(moved(x, t, p[1] * hour), t, abs(p[0]) * 3 * hour)], [1.0, -0.3]),
    }
