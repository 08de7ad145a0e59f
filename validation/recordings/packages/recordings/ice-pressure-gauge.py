"""A pressure gauge at the end of a hose that is drilled into a glacier, over the distance that an echo sounder on a stake tells, beside the pressure of the air, one August, each 10 min. The ice melts; the air presses on the hose."""

from models.fitting import line, terms
from models.lags import lag, usual
from readers.pypromice import logger_table

HAND_BUILT = "air pressure, and late surface"


def rows(content):
    frame = logger_table(content, "SurfaceHeight", "AirPressure_Avg", "IceHeight_Avg")
    return {"time_s": frame.time_s, "surface_m": frame.SurfaceHeight, "air_pressure_hpa": frame.AirPressure_Avg, "gauge_mv": frame.IceHeight_Avg}


def models(c):
    y, x, t, air = c["gauge_mv"], c["surface_m"], c["time_s"], c["air_pressure_hpa"]
    late = lambda p: lag(x, t, abs(p) * 3600)
    return y, {
        **usual(y, x, t, 3600),
        "air pressure": line(y, x, air),
        "air pressure, and square": line(y, x, x**2, air),
        "air pressure, and drift": line(y, x, air, t),
        HAND_BUILT: terms(y, lambda p: [late(p[0]), air], [3.0]),
        "air pressure, and a part late": terms(y, lambda p: [x, late(p[0]), air], [10.0]),
    }
