"""Battery of an underwater glider while its pump runs, 14 dives, one a run: the voltage falls with the current, and the more the longer the pump is on. One row for each run of the pump."""

import numpy as np
from models.fitting import line, terms
from readers.glidertools import dives

HAND_BUILT = "current times time that settles"


def rows(*contents):
    names = {"time_s": "gc_st_secs", "current_a": "gc_vbd_i", "on_for_s": "gc_vbd_secs", "battery_v": "gc_vbd_volts"}
    d = dives(contents, names)
    d = d[(d.on_for_s > 1) & (d.current_a > 0.2)]
    return {"dive": d.dive, "time_s": d.time_s - d.time_s.iloc[0], **{name: d[name] for name in ("current_a", "on_for_s", "battery_v")}}


def models(c):
    y, x, on, t = c["battery_v"], c["current_a"], c["on_for_s"], c["time_s"]
    settled = terms(y, lambda p: [x, x * (1 - np.exp(-on / (5 + abs(p[0]))))], [30.0])
    return y, {"line": line(y, x), "time on": line(y, x, on), "product": line(y, x, x * on), "time and product": line(y, x, on, x * on), HAND_BUILT: settled, "time on and drift": line(y, x, on, t)}
