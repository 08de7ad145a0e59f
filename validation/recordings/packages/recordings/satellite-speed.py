"""Speed that a bicycle computer shows, beside that which its places by satellite make from row to row, the first 6000 seconds. They agree but for the noise of the places."""

import numpy as np
from models.fitting import line, terms
from models.lags import lag
from readers.sweat import trackpoints

HAND_BUILT = "shift"


def rows(content):
    frame = trackpoints(content).iloc[:6000]
    t, north, east = frame.time_s, np.radians(frame.north), np.radians(frame.east)
    by_places = 6371000 * np.hypot(np.gradient(north, t), np.gradient(east, t) * np.cos(north))
    return {"time_s": t, "by_places_m_s": by_places, "speed_m_s": frame.speed}


def models(c):
    y, x, t = c["speed_m_s"], c["by_places_m_s"], c["time_s"]
    return y, {
        "line": line(y, x),
        "square": line(y, x, x**2),
        "drift": line(y, x, t),
        HAND_BUILT: terms(y, lambda p: [np.interp(t - p[0] * 2, t, x)], [0.5]),
        "lag": terms(y, lambda p: [lag(x, t, abs(p[0]) * 2)], [0.5]),
    }
