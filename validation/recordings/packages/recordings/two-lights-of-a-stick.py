"""What the fourth sensor in the tip of a pole tells over the third, beside the first, while the pole goes along a stick that was made to test it."""

from models.drifts import usual_shifts_and_drifts
from models.drivers import drivers_and_drift, of_drivers
from models.fitting import line, scaled, terms
from models.lags import lag, moved
from readers.study_lyte import push

HAND_BUILT = "lag, and first, bent"


def rows(content):
    told = push(content, 15)
    return {"time_s": told["time"], "first": told["Sensor1"], "third": told["Sensor3"], "fourth": told["Sensor4"]}


def models(c):
    y, x, t = c["fourth"], c["third"], c["time_s"]
    v, w = scaled(c["first"]), scaled(t)
    at, late = lambda p: moved(x, t, p[0] * 0.01), lambda p: lag(x, t, abs(p[0]) * 0.01)
    return y, {
        **usual_shifts_and_drifts(y, x, t, 0.01),
        **of_drivers(y, x, first=c["first"]),
        **drivers_and_drift(y, x, t, first=c["first"]),
        "shift, and first": terms(y, lambda p: [at(p), v], [0.3]),
        "shift, and first, bent": terms(y, lambda p: [at(p), v, v**2], [0.3]),
        "lag, and first": terms(y, lambda p: [late(p), v], [0.3]),
        "lag, and first, bent": terms(y, lambda p: [late(p), v, v**2], [0.3]),
        "lag, first, bent, and drift": terms(y, lambda p: [late(p), v, v**2, w], [0.3]),
        "lag, square, and first, bent": terms(y, lambda p: [late(p), late(p) ** 2, v, v**2], [0.3]),
        "first that is shifted": terms(y, lambda p: [x, moved(v, t, p[0] * 0.01)], [0.3]),
        "first, bent": line(y, x, v, v**2),
    }
