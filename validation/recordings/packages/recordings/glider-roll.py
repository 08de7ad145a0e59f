"""Roll of an underwater glider over the angle to which it turns its battery, 14 dives, one a run, every tenth row: straight, and little else; deeper, it rolls a little less."""

import numpy as np
from models.fitting import line
from readers.glidertools import dives

HAND_BUILT = "depth and product"


def rows(*contents):
    names = {"time_s": "time", "battery_deg": "eng_rollCtl", "depth_db": "pressure", "roll_deg": "eng_rollAng", "phase": "eng_GC_phase"}
    d = dives(contents, names)
    d = d[(d.depth_db > 15) & (d.phase == 6)].iloc[::10]
    return {"dive": d.dive, "time_s": (d.time_s - d.time_s.iloc[0]).round(3), **{name: d[name] for name in ("battery_deg", "depth_db", "roll_deg")}}


def models(c):
    y, x, depth = c["roll_deg"], c["battery_deg"], c["depth_db"]
    return y, {"line": line(y, x), "cubic": line(y, x, x**2, x**3), "depth": line(y, x, depth), "sign": line(y, x, np.sign(x)), HAND_BUILT: line(y, x, depth, x * depth)}
