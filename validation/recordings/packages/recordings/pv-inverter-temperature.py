"""Temperature of an inverter: it heats as soon as it is on, more than in proportion to its power, and with a lag."""

from models.fitting import line, terms
from models.lags import lag
from readers.pvanalytics import solar_array

HAND_BUILT = "power that levels off, lagged, and ambient, lagged"


def rows(content):
    d = solar_array(content)
    return {"time_s": d.time_s, "ac_power_kw": d.ac_power / 1e3, "ambient": d.ambient, "inverter_temp": d.inverter_temp}


def models(c):
    y, t, power, ambient = c["inverter_temp"], c["time_s"], c["ac_power_kw"], c["ambient"]
    lagged = terms(y, lambda p: [lag(power, t, abs(p[0])), lag(ambient, t, abs(p[1]))], [3600.0, 3600.0])

    def levelled(p):
        return [lag(power / (1 + abs(p[2]) * power), t, abs(p[0])), lag(ambient, t, abs(p[1]))]

    return y, {"line": line(y, power), "power and ambient, lagged": lagged, HAND_BUILT: terms(y, levelled, [3600.0, 3600.0, 0.02])}
