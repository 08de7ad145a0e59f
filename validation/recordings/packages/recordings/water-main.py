"""Flow through a branch of a water main for 27 days between two closures: least in the afternoon; one hour is wild, a day and a half are missing."""

import pandas as pd
from formats.clock import seconds
from formats.text import csv
from models.cycles import tone
from models.fitting import line

HAND_BUILT = "two waves of the day"


def rows(content):
    d = csv(content).iloc[240:870]
    return {"time_s": seconds(pd.to_datetime(d.iloc[:, 0], utc=True)), "flow": d.iloc[:, 1]}


def models(c):
    y, t = c["flow"], c["time_s"]
    day, half = tone(t, 86400.0), tone(t, 43200.0)
    weekly = [*day, *half, *tone(t, 7 * 86400.0)]
    return y, {"constant": line(y), "drift": line(y, t), "one wave": line(y, *day), HAND_BUILT: line(y, *day, *half), "and the week": line(y, *weekly)}
