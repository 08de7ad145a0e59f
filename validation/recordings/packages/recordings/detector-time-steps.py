"""Time of a detector of cosmic rays against its neighbour, a day each, eleven years. It steps by 15 ns, and drifts before and after."""

from probes import drifts, timing

HAND_BUILT = "step, and a drift before and after"


def rows(content):
    time, late = timing(content, 1)
    return {"time_s": time, "late_ns": late}


def models(c):
    return c["late_ns"], drifts(c["late_ns"], c["time_s"])
