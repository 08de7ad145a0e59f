"""How bright a part of a fly's brain is, by a dye that glows where it is at work, over how quickly the fly walks, beside how it turns."""

from models.drifts import usual_shifts_and_drifts
from models.drivers import of_drivers
from models.fitting import scaled, terms
from models.lags import behind, lag, moved
from readers.pyedm import FRAME_S, fly

HAND_BUILT = "lag, and drift"
ROW_S = 10 * FRAME_S


def rows(content):
    return fly(content, "TS5")


def models(c):
    y, x, t = c["glow"], c["walk"], c["time_s"]
    w, v = scaled(t), scaled(c["turn"])
    late = lambda p: lag(x, t, abs(p[0]) * ROW_S)
    return y, {
        **usual_shifts_and_drifts(y, x, t, ROW_S),
        **of_drivers(y, x, turn=c["turn"]),
        **behind(y, x, t, ROW_S),
        "lag, drift, and square": terms(y, lambda p: [late(p), late(p) ** 2, w], [2.0]),
        "lag, and slope that drifts": terms(y, lambda p: [late(p), w, w * late(p)], [2.0]),
        "lag, drift, and turn": terms(y, lambda p: [late(p), w, v], [2.0]),
        "lag, drift, and shift": terms(y, lambda p: [moved(late(p), t, p[1] * ROW_S), w], [2.0, 1.0]),
        "lag, drift, and its square": terms(y, lambda p: [late(p), w, w**2], [2.0]),
    }
