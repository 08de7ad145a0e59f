"""Power of a wind turbine: an S over wind speed with a ceiling, nothing while the blades are turned out of the wind, less in warm air."""

import numpy as np
import pandas as pd
from formats.clock import seconds
from formats.packed import in_zip
from formats.text import csv
from models.fitting import line, terms

HAND_BUILT = "an S while the pitch is small, and density"


def rows(content):
    d = csv(in_zip(content, "la-haute-borne-data-2014-2015.csv"))
    d = d[d.Wind_turbine_name == "R80711"]
    d = d.assign(t=pd.to_datetime(d.Date_time, utc=True)).sort_values("t").drop_duplicates("t")
    d = d[(d.t >= "2014-02-01") & (d.t < "2014-03-01")].dropna()
    return {"time_s": seconds(d.t), "wind_speed": d.Ws_avg, "pitch": d.Ba_avg, "outdoor_c": d.Ot_avg, "power_kw": d.P_avg}


def models(c):
    y, wind, pitch, warm = c["power_kw"], c["wind_speed"], c["pitch"], c["outdoor_c"]

    def s(p):
        return 1 / (1 + np.exp(-(wind - p[0]) / p[1]))

    def with_pitch(p):
        on = pitch < p[2]
        return [on * s(p), on * warm * s(p), on * 1.0]

    return y, {"line": line(y, wind), "an S": terms(y, lambda p: [s(p)], [8.5, 1.5]), HAND_BUILT: terms(y, with_pitch, [8.5, 1.5, 20.0])}
