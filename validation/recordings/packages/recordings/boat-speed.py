"""Speed of a rowing boat over ground by satellite, beside that through the water by an impeller, stroke by stroke on a river.

Half way the boat turns, and the stream helps where it hindered. Until it turns again.
"""

import numpy as np
from models.fitting import line, terms
from readers.rowingdata import speed_coach

SECOND_TURN = 2300.0  # s
HAND_BUILT = "stream that turns round"


def rows(content):
    d = speed_coach(content)[["time_s", "Speed (IMP)", "Speed (GPS)"]].dropna()
    d = d[(d.time_s < SECOND_TURN) & (d["Speed (IMP)"] > 6) & (d.time_s.diff().fillna(1) > 0)]
    return {"time_s": d.time_s - d.time_s.iloc[0], "impeller_km_h": d["Speed (IMP)"], "satellite_km_h": d["Speed (GPS)"]}


def models(c):
    y, x, t = c["satellite_km_h"], c["impeller_km_h"], c["time_s"] / 60

    def turned(p, width=0.3):
        return 0.5 * (1 + np.tanh((t - p[0]) / width))

    return y, {
        "line": line(y, x),
        "drift": line(y, x, t),
        HAND_BUILT: terms(y, lambda p: [x, turned(p)], [29.0]),
        "stream that turns round, and drift": terms(y, lambda p: [x, turned(p), t, t * turned(p)], [29.0]),
        "stream and gain": terms(y, lambda p: [x, turned(p), x * turned(p)], [29.0]),
    }
