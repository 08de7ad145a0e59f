"""Rate at which an aircraft says that its track turns, beside what bank and airspeed make of it in a clean turn; the first 6000 rows in which either changes. Next to nothing is missing: it turns a second after it banks."""

import numpy as np
from models.fitting import line, terms
from models.lags import lag
from readers.traffic import flight

HAND_BUILT = "lag"


def rows(content):
    frame = flight(content).dropna(subset=["roll", "track_rate", "TAS"])
    frame = frame[((frame.roll.diff() != 0) | (frame.track_rate.diff() != 0)) & (frame.TAS > 100)].iloc[:6000]
    turn = np.degrees(9.81 * np.tan(np.radians(frame.roll)) / (0.5144 * frame.TAS))
    return {"time_s": frame.time_s, "by_bank_deg_s": turn, "turn_deg_s": frame.track_rate}


def models(c):
    y, x, t = c["turn_deg_s"], c["by_bank_deg_s"], c["time_s"]
    return y, {
        "line": line(y, x),
        "square": line(y, x, x**2),
        "drift": line(y, x, t),
        "shift": terms(y, lambda p: [np.interp(t - p[0] * 3, t, x)], [0.5]),
        HAND_BUILT: terms(y, lambda p: [lag(x, t, abs(p[0]) * 3)], [0.5]),
    }
