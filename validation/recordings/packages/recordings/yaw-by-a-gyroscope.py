"""How far the tower of a wind turbine yaws, by cameras, over what a gyroscope on it says that it has turned since the first row, in waves of a basin."""

from formats.rows import summed
from models.fitting import line, terms
from models.lags import lag, moved, usual_and_shifts
from readers.qats import wave_basin

HAND_BUILT = "shift, and drift"


def rows(content):
    told = wave_basin(content, gyroscope="Z_GYRO_TOWER", cameras_deg="TOWER_YAW")
    return {"time_s": told["time_s"], "gyroscope_deg": summed(told["gyroscope"].to_numpy(), told["time_s"]), "cameras_deg": told["cameras_deg"]}


def models(c):
    y, x, t = c["cameras_deg"], c["gyroscope_deg"], c["time_s"]
    return y, {
        **usual_and_shifts(y, x, t, 0.05),
        "drift, and its square": line(y, x, t, t**2),
        "square, and drift": line(y, x, x**2, t),
        "lag, and drift": terms(y, lambda p: [lag(x, t, abs(p[0]) * 0.05), t], [0.5]),
        "shift, drift, and its square": terms(y, lambda p: [moved(x, t, p[0] * 0.05), t, t**2], [-0.5]),
    }
