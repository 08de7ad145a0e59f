"""Two potentiometers on the piston of an underwater glider, 14 dives, one a run: the piston tilts as the sea presses on it and as it is pumped, and one potentiometer is a little bent."""

import numpy as np
from models.fitting import line, scaled
from readers.glidertools import dives

HAND_BUILT = "cubic"


def rows(*contents):
    names = {"time_s": "gc_st_secs", "second_counts": "gc_vbd_pot2_ad", "depth_db": "gc_depth", "first_counts": "gc_vbd_pot1_ad"}
    d = dives(contents, names)
    d = d[d.groupby("dive").time_s.diff().fillna(1) > 0]
    return {"dive": d.dive, "time_s": d.time_s - d.time_s.iloc[0], **{name: d[name] for name in ("second_counts", "depth_db", "first_counts")}}


def models(c):
    y, x, depth = c["first_counts"], c["second_counts"], c["depth_db"]
    u = scaled(x)
    return y, {
        "line": line(y, x),
        "square": line(y, u, u**2),
        "depth": line(y, u, depth),
        HAND_BUILT: line(y, u, u**2, u**3),
        "cubic and depth": line(y, u, u**2, u**3, depth, depth * u),
        "two hinges": line(y, u, np.maximum(u, 0), np.maximum(u + 0.8, 0)),
    }
