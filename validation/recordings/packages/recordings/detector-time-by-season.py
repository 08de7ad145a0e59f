"""Time of a detector of cosmic rays against its neighbour, a day each, four years. It goes with the season."""

from probes import drifts, timing

HAND_BUILT = "year"


def rows(content):
    time, late = timing(content, 1, begin=15)
    return {"time_s": time, "late_ns": late}


def models(c):
    return c["late_ns"], drifts(c["late_ns"], c["time_s"])
