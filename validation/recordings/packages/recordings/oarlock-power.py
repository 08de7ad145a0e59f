"""Power that the oarlock of a rowing boat shows, over the mean force on its handle, stroke by stroke: it is force times way times strokes a minute, and the way is no column."""

from models.fitting import line
from readers.rowingdata import speed_coach

HAND_BUILT = "product and both"


def rows(content):
    d = speed_coach(content)[["time_s", "Force Avg", "Stroke Rate", "Power"]].dropna()
    d = d[(d["Force Avg"] > 60) & d["Stroke Rate"].between(15, 35) & (d.time_s.diff().fillna(1) > 0)]
    return {"time_s": d.time_s - d.time_s.iloc[0], "handle_n": d["Force Avg"], "strokes_per_min": d["Stroke Rate"], "power_w": d.Power}


def models(c):
    y, x, rate, t = c["power_w"], c["handle_n"], c["strokes_per_min"], c["time_s"]
    return y, {
        "line": line(y, x),
        "rate": line(y, x, rate),
        "product": line(y, x * rate),
        HAND_BUILT: line(y, x, rate, x * rate),
        "rate and drift": line(y, x, rate, t),
        "square and rate": line(y, x, x**2, rate),
    }
