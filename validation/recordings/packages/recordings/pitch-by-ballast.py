"""Pitch of a glider over the water that it has pumped, below 30 m, where it turns upwards eighteen times. The pitch is late, or the law is bent: it turns one way only."""

from models.bends import usual_and_bends
from models.fitting import scaled, terms
from models.lags import moved, usual_and_lags
from readers.gliderflight import sinking_glider

HAND_BUILT = "fifth power, and lag"


def rows(content):
    frame = sinking_glider(content)
    frame = frame[frame.pressure_bar > 3]
    return {"time_s": frame.time_s, "pumped_cm3": frame.pumped_cm3, "pitch_rad": frame.pitch_rad}


def models(c):
    y, x, t = c["pitch_rad"], c["pumped_cm3"], c["time_s"]
    u = scaled(x)
    return y, {
        **usual_and_lags(y, x, t, 5),
        **usual_and_bends(y, x, t, 5),
        "square that is shifted": terms(y, lambda p: [moved(u, t, p[0] * 5), moved(u, t, p[0] * 5) ** 2], [0.5]),
    }
