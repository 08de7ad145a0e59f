"""Reads files of the package tstoolbox, and holds models that its recordings share."""

from formats.clock import seconds
from formats.text import csv
from models.fitting import terms
from models.lags import lag, moved, usual


def river_gauges(first, second, column, rows=3500):
    """The same column of two daily tables of a river, by days that both have, with seconds since the first."""
    frames = [csv(content, index_col=0, parse_dates=True).iloc[:, [column]] for content in (first, second)]
    both = frames[0].join(frames[1], lsuffix="_1", rsuffix="_2").dropna().iloc[:rows]
    return seconds(both.index), both.iloc[:, 0].to_numpy(float), both.iloc[:, 1].to_numpy(float)


def river_models(y, x, t, day=86400):
    """Models of a gauge `y` by that upstream, `x`, at times `t`; water comes later, and may come slowly."""
    shifted = lambda p: moved(x, t, p * day)
    return {
        **usual(y, x, t, day),
        "shift, and lag": terms(y, lambda p: [lag(shifted(p[0]), t, abs(p[1]) * day)], [0.5, 0.5]),
        "shift, and square": terms(y, lambda p: [shifted(p[0]), shifted(p[0]) ** 2], [0.5]),
        "line and lag": terms(y, lambda p: [x, lag(x, t, abs(p[0]) * day)], [1.0]),
    }
