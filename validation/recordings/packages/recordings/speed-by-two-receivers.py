"""How fast a car goes by a receiver of satellites, over an instrument with gyroscopes and a better one, 1000 s. The cheaper one tells it later."""

from models.fitting import line, scaled, terms
from models.lags import behind, lag, moved, usual_and_shifts
from readers.pntos_cobra_datasets_lcm import drive_by_speed

HAND_BUILT = "shift"


def rows(content):
    return drive_by_speed(content, 600, 1600)


def models(c):
    y, x, t = c["receiver_m_s"], c["inertial_m_s"], c["time_s"]
    u, w = scaled(x), scaled(t)
    at = lambda p: moved(x, t, p)
    return y, {
        **usual_and_shifts(y, x, t, 1.0),
        "drift, and slope that drifts": line(y, x, w, u * w),
        **behind(y, x, t, 1.0),
        "shift, and a lag": terms(y, lambda p: [lag(at(p[0]), t, abs(p[1]))], [0.2, 0.1]),
        "shift that drifts": terms(y, lambda p: [moved(x, t, p[0] + p[1] * w)], [0.3, 0.01]),
    }
