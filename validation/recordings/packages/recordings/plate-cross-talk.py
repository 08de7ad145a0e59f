"""Upward force of a bare force plate over the voltage of its own channel, beside the voltages of two other channels, a minute, 50 rows a second. Its software adds a little of the others."""

from models.fitting import line
from models.lags import usual
from readers.gaitanalysistoolkit import bare_plates

HAND_BUILT = "both others"


def rows(content):
    frame = bare_plates(content, "FP1.ForZ", "Channel2.Anlg", "Channel3.Anlg", "Channel6.Anlg")
    return {
        "time_s": frame.time_s,
        "channel_6_mv": frame["Channel6.Anlg"] * 1000,
        "channel_2_mv": frame["Channel2.Anlg"] * 1000,
        "channel_3_mv": frame["Channel3.Anlg"] * 1000,
        "force_n": frame["FP1.ForZ"],
    }


def models(c):
    y, x, t, second, third = c["force_n"], c["channel_6_mv"], c["time_s"], c["channel_2_mv"], c["channel_3_mv"]
    return y, {**usual(y, x, t, 0.02), "second": line(y, x, second), "third": line(y, x, third), HAND_BUILT: line(y, x, second, third)}
