"""Time of a detector of cosmic rays against its neighbour, a day each, eleven years. It drifts."""

from probes import drifts, timing

HAND_BUILT = "drift, and its square"


def rows(content):
    time, late = timing(content, 1, begin=1)
    return {"time_s": time, "late_ns": late}


def models(c):
    return c["late_ns"], drifts(c["late_ns"], c["time_s"])
