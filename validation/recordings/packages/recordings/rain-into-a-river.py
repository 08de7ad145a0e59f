"""Water of the Dill over the rain on its valley, 150 days of a wet winter."""

from durations import DAY
from models.fitting import line, scaled, terms
from models.lags import behind, lag, usual_and_shifts
from readers.hydpy import valley

HAND_BUILT = "two lags, and square of the sum"


def rows(*contents):
    return valley(*contents, first=1826, days=150, names=("rain_mm_d", "water_m3_s"))


def models(c):
    y, x, t = c["water_m3_s"], c["rain_mm_d"], c["time_s"]
    u, w, late = scaled(x), scaled(t), lambda p: lag(x, t, abs(p) * DAY)
    return y, {
        **usual_and_shifts(y, x, t, DAY),
        "drift, and slope that drifts": line(y, x, w, u * w),
        **behind(y, x, t, 2 * DAY),
        "lag, square, and drift": terms(y, lambda p: [late(p[0]), late(p[0]) ** 2, w], [2.0]),
        "lag, drift, and its square": terms(y, lambda p: [late(p[0]), w, w**2], [2.0]),
        "lag, and slope that drifts": terms(y, lambda p: [late(p[0]), w * late(p[0])], [2.0]),
        "lag, square, and slope that drifts": terms(y, lambda p: [late(p[0]), late(p[0]) ** 2, w * late(p[0])], [2.0]),
        "lag, square, and cube": terms(y, lambda p: [late(p[0]), late(p[0]) ** 2, late(p[0]) ** 3], [2.0]),
        "two lags, and square of the sum": terms(y, lambda p: [late(p[0]), late(p[1]), (late(p[0]) + late(p[1])) ** 2], [2.0, 8.0]),
    }
