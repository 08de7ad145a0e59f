"""Temperature of solar modules over that of the air, each fifth hour of day in a year. The sun warms them, and the wind takes that away."""

from durations import DAY
from models.cycles import tone
from models.drivers import of_drivers
from models.fitting import line, terms
from models.lags import lag
from readers.pvops import solar_plant

HAND_BUILT = "sun over wind"


def rows(content):
    read = solar_plant(content, "R10", 5)
    return {"time_s": read.time_s, "sun_w_m2": read.irrad_poa_Wm2, "wind_m_s": read.wind_speed_ms, "air_degc": read.temp_amb_C, "module_degc": read.temp_mod_C}


def models(c):
    y, x, sun, wind, t = c["module_degc"], c["air_degc"], c["sun_w_m2"] / 100, c["wind_m_s"], c["time_s"]
    over = lambda p: sun / (abs(p) + wind)
    return y, {
        **of_drivers(y, x, sun=sun),
        "wind": line(y, x, wind),
        "sun, and wind": line(y, x, sun, wind),
        "sun, and slope of it by wind": line(y, x, sun, sun * wind),
        "sun, wind, and product": line(y, x, sun, wind, sun * wind),
        "line and lag, and sun over wind": terms(y, lambda p: [x, lag(x, t, abs(p[1]) * 3600), over(p[0])], [5.0, 3.0]),
        "sun over wind": terms(y, lambda p: [x, over(p[0])], [5.0]),
        "sun over wind, and both alone": terms(y, lambda p: [x, over(p[0]), sun, wind], [5.0]),
        "sun over wind, and square": terms(y, lambda p: [x, x**2, over(p[0])], [5.0]),
        "sun over wind, and day": terms(y, lambda p: [x, over(p[0]), *tone(t, DAY)], [5.0]),
        "sun over wind, and drift": terms(y, lambda p: [x, over(p[0]), t], [5.0]),
    }
