"""Flow of air through a soot photometer, held at 120 cm3/min by its controller, a day in means of a minute, as the chamber cools and warms by 10 K: it holds. There is more noise in the morning."""

import io

import numpy as np
import pandas as pd
from formats.rows import means
from models.fitting import line

HAND_BUILT = "constant"


def rows(content):
    names = {"chamber_c": "Chamber Temp (C)", "chamber_hpa": "Chamber Pressure (mBar)", "flow_cm3_min": "Sample Flow LFE (vccm)"}
    d = pd.read_csv(io.BytesIO(content), sep="\t", usecols=["Time (sec)", *names.values()])
    t = means(d["Time (sec)"], 60)
    return {"time_s": (t - t[0]).round(1), **{name: means(d[column], 60) for name, column in names.items()}}


def models(c):
    y, x, t = c["flow_cm3_min"], c["chamber_c"], c["time_s"]
    return y, {"constant": line(y), "temperature": line(y, x), "pressure": line(y, c["chamber_hpa"]), "drift": line(y, t), "rate of temperature": line(y, np.gradient(x))}
