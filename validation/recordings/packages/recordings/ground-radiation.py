"""Infrared that comes up from the ground (a pyrgeometer, one winter day) against that of a black body as warm as the air at 10 m: the sun warms the ground more."""

import numpy as np
from models.fitting import line, terms
from models.lags import lag

HAND_BUILT = "sun"


def rows(content):
    a = np.array([[float(v) for v in line.split()] for line in content.decode().splitlines()[2:]])
    a = a[(a[:, [8, 22, 38, 42]] > -9000).all(axis=1)]
    time, sun, upwelling, air, wind = a[:, 6] * 3600, a[:, 8], a[:, 22], a[:, 38], a[:, 42]
    return {"time_s": np.round(time / 60) * 60, "black_body": 5.670374e-8 * (air + 273.15) ** 4, "sun_w_m2": sun, "wind_m_s": wind, "upwelling": upwelling}


def models(c):
    y, x, t, sun, wind = c["upwelling"], c["black_body"], c["time_s"], c["sun_w_m2"], c["wind_m_s"]
    late = terms(y, lambda p: [x, lag(sun, t, abs(p[0]))], [3000.0])
    return y, {"line": line(y, x), HAND_BUILT: line(y, x, sun), "sun and wind": line(y, x, sun, wind), "sun, with a lag": late}
