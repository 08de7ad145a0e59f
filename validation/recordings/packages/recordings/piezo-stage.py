"""Stage of a force microscope as its capacitive sensor sees it, over the voltage of its piezo: out for three seconds, held at one force for three, back for three. A piezo lags behind on the way back."""

import numpy as np
from models.fitting import line, terms
from models.lags import lag
from readers.afmformats import jpk

HAND_BUILT = "way up and way down, each a square"


def rows(content):
    t, command, sensed, begin = [], [], [], 0.0
    for duration, channels in jpk(content):
        n = len(channels["height"])
        t.append(begin + (np.arange(n) * duration / n)[::6])
        command.append(channels["height"][::6])
        sensed.append(channels["measuredHeight"][::6] * -1e6)
        begin += duration
    t, command, sensed = map(np.concatenate, (t, command, sensed))
    return {"time_s": t.round(6), "command_v": command, "sensed_um": sensed - sensed[0]}


def models(c):
    y, x, t = c["sensed_um"], c["command_v"], c["time_s"]
    u = (x - x.min()) / np.ptp(x)
    turn = u[int(np.argmax(x))]
    back = (np.arange(len(x)) > np.argmax(x)) * 1.0
    away = (turn - u) * back

    def plays(p):
        return [u, *[played(u, abs(width)) for width in p]]

    return y, {
        "line": line(y, x),
        "square": line(y, u, u**2),
        "creep": terms(y, lambda p: [u, lag(u, t, abs(p[0]))], [1.0]),
        "one play": terms(y, plays, [0.1]),
        "two plays": terms(y, plays, [0.1, 0.4]),
        "cubic": line(y, u, u**2, u**3),
        HAND_BUILT: line(y, u, u**2, away, away**2),
    }


def played(u, width):
    """A play of half this width: it stands until it is pushed or pulled."""
    out, at = np.empty(len(u)), u[0]
    for k, value in enumerate(u):
        at = min(max(at, value - width / 2), value + width / 2)
        out[k] = at
    return out
