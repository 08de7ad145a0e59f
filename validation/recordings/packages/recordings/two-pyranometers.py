"""Two pyranometers of one make on a clear day: one looks a little to the east of the other, so that its day is early. Both are shaded for some minutes."""

import numpy as np
from formats.text import csv
from models.fitting import line, terms

HAND_BUILT = "shift in time"


def rows(content):
    d = csv(content)
    d.columns = [name.strip() for name in d.columns]
    d = d[(d.MST >= 700) & (d.MST < 1700)]
    minutes = d.MST // 100 * 60 + d.MST % 100
    picked = d[["Global Horiz (tracker) [W/m^2]", "Global Horiz (platform) [W/m^2]", "Avg Wind Speed @ 3m [m/s]"]].to_numpy().T
    return {"time_s": (minutes - minutes.iloc[0]) * 60.0, "tracker": picked[0], "platform": picked[1], "wind_m_s": picked[2]}


def models(c):
    y, x, t = c["platform"], c["tracker"], c["time_s"]
    steep = np.gradient(x, t)
    return y, {"line": line(y, x), HAND_BUILT: terms(y, lambda p: [np.interp(t + 60 * p[0], t, x)], [1.0]), "hour": line(y, x, x * t), "slope": line(y, x, steep)}
