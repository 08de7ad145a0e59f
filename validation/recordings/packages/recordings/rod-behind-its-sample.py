"""Height at which a magnetometer finds the centre of its sample, at the end of a long rod, over the warmth of the sample: twice warmed from 2 K to 300 K and cooled back."""

import numpy as np
from formats.clock import since_first
from formats.rows import numbered
from models.fitting import line, terms
from models.lags import in_runs, lag, moved, play
from readers.ppms_toolkit import moments

HAND_BUILT = "play, and cube"


def rows(*contents):
    frames = [moments(content, 4) for content in contents]
    joined = {name: np.concatenate([frame[name] for frame in frames]) for name in ("Time Stamp (sec)", "Temperature (K)", "Center Position (mm)")}
    return {"run": numbered(frames), "time_s": since_first(joined["Time Stamp (sec)"]).round(1), "sample_k": joined["Temperature (K)"], "centre_mm": joined["Center Position (mm)"]}


def models(c):
    y, x, t, run = c["centre_mm"], c["sample_k"], c["time_s"], c["run"]
    powers = lambda v: [v / 100, (v / 100) ** 2, (v / 100) ** 3]
    late = lambda p: in_runs(run, t, lambda rows, s: lag(x[rows], s, (abs(p) + 0.01) * 1000))
    later = lambda p: in_runs(run, t, lambda rows, s: moved(x[rows], s, p * 1000))
    loose = lambda p: in_runs(run, t, lambda rows, s: play(x[rows], abs(p) * 10))
    fades = lambda p: in_runs(run, t, lambda rows, s: np.exp(-s / (abs(p) + 0.01) / 1000)) * (run % 2)
    warmed = (run % 2).astype(float)
    return y, {
        "line": line(y, x),
        "square": line(y, x, x**2),
        "cube": line(y, *powers(x)),
        "drift": line(y, x, t),
        "direction": line(y, x, warmed),
        "shift": terms(y, lambda p: [later(p[0])], [0.5]),
        "shift, and cube": terms(y, lambda p: powers(later(p[0])), [0.5]),
        "lag": terms(y, lambda p: [late(p[0])], [0.5]),
        "lag, and square": terms(y, lambda p: powers(late(p[0]))[:2], [0.5]),
        "lag, and cube": terms(y, lambda p: powers(late(p[0])), [0.5]),
        "lag, and what fades": terms(y, lambda p: [late(p[0]), fades(p[0])], [0.5]),
        "lag, what fades, and cube": terms(y, lambda p: [*powers(late(p[0])), fades(p[0])], [0.5]),
        "play": terms(y, lambda p: [loose(p[0])], [3.0]),
        "play, and square": terms(y, lambda p: powers(loose(p[0]))[:2], [3.0]),
        "play, and cube": terms(y, lambda p: powers(loose(p[0])), [3.0]),
    }
