"""Temperature of solar modules over the light on them, beside that of the air and the wind, five days, each five minutes. They are warmer where the air is, and need minutes to warm up."""

from models.fitting import line, terms
from models.lags import lag, usual
from readers.captest import solar_plant

HAND_BUILT = "late light, and air"


def rows(content):
    frame = solar_plant(content)
    return {"time_s": frame.time_s, "light_w_m2": frame.met2_poa_pyranometer, "wind_m_s": frame.met2_windspeed, "air_c": frame.met2_amb_temp, "module_c": frame.met2_mod_temp1}


def models(c):
    y, x, t, air, wind = c["module_c"], c["light_w_m2"], c["time_s"], c["air_c"], c["wind_m_s"]
    late = lambda p: lag(x, t, abs(p) * 600)
    return y, {
        **usual(y, x, t, 600),
        "air": line(y, x, air),
        "air, and wind": line(y, x, air, wind, wind * x),
        HAND_BUILT: terms(y, lambda p: [late(p[0]), air], [0.5]),
        "late light, air, and wind": terms(y, lambda p: [late(p[0]), air, wind, wind * late(p[0])], [0.5]),
    }
