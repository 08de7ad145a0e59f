"""Way of the stage of an indenter over that of its tip, one push and back. The frame gives way under the force, and the tip is corrected for a drift."""

from models.fitting import line
from readers.nanodent import indenter

HAND_BUILT = "force and drift"


def rows(content):
    frame = indenter(content)
    return {"time_s": frame.Time_s, "tip_um": frame.Disp_nm / 1000, "force_mn": frame.Force_uN / 1000, "stage_um": frame.PiezoDisp_nm / 1000}


def models(c):
    y, x, t, force = c["stage_um"], c["tip_um"], c["time_s"], c["force_mn"]
    return y, {
        "line": line(y, x),
        "square": line(y, x, x**2),
        "drift": line(y, x, t),
        "force": line(y, x, force),
        "force, bent": line(y, x, force, force**2),
        HAND_BUILT: line(y, x, force, t),
    }
