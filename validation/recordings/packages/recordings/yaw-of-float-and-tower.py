"""How far the tower of a wind turbine yaws over how far its float does, by cameras, in waves of a basin. A tower does not twist."""

from models.fitting import line
from models.lags import usual_and_shifts
from readers.qats import wave_basin

HAND_BUILT = "line"


def rows(content):
    return wave_basin(content, float_deg="FLOATER_YAW", tower_deg="TOWER_YAW")


def models(c):
    y, x, t = c["tower_deg"], c["float_deg"], c["time_s"]
    return y, {**usual_and_shifts(y, x, t, 0.05), "cube": line(y, x, x**2, x**3), "square, and drift": line(y, x, x**2, t)}
