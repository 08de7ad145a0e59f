"""How strong a satellite's precise code is over its open one at the same frequency, in dB, more than two hours until it sets."""

from models.drifts import usual_shifts_and_drifts
from models.fitting import line, scaled
from models.jumps import changed
from readers.georinex import observed

HAND_BUILT = "line"


def rows(content):
    told = observed(content, "R16", "S1C", "S1P")
    return {"time_s": told["time_s"], "open_dbhz": told["S1C"], "precise_dbhz": told["S1P"]}


def models(c):
    y, x, t = c["precise_dbhz"], c["open_dbhz"], c["time_s"]
    w = scaled(t)
    return y, {**usual_shifts_and_drifts(y, x, t, 15), "drift, its square and cube": line(y, x, w, w**2, w**3), "step": changed(y, t, [x], 1.0)}
