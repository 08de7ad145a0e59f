"""Deflection of the load cell of an indenter over its voltage, one push into the sample and back. Its calibration is bent."""

from models.fitting import line, terms
from models.lags import lag
from readers.nanodent import indenter

HAND_BUILT = "square"


def rows(content):
    frame = indenter(content)
    return {"time_s": frame.Time_s, "force_v": frame.Force_V, "load_cell_nm": frame.LoadCell_nm}


def models(c):
    y, x, t = c["load_cell_nm"], c["force_v"], c["time_s"]
    u = (x - x.min()) / (x.max() - x.min())
    return y, {
        "line": line(y, u),
        HAND_BUILT: line(y, u, u**2),
        "cubic": line(y, u, u**2, u**3),
        "drift": line(y, u, t),
        "line and lag": terms(y, lambda p: [u, lag(u, t, abs(p[0]))], [0.1]),
    }
