"""Temperature of a solar module: ambient, light that wind takes away, and a thermal lag of both."""

from models.fitting import line, terms
from models.lags import lag
from readers.pvanalytics import solar_array

HAND_BUILT = "ambient, light over wind, lag"


def rows(content):
    return solar_array(content)[["time_s", "ambient", "poa", "wind", "module"]]


def models(c):
    y, t, ambient, light, wind = c["module"], c["time_s"], c["ambient"], c["poa"], c["wind"]

    def lagged(p):
        return [lag(light / (1 + abs(p[0]) * wind), t, abs(p[1])), lag(ambient, t, abs(p[1])), ambient]

    return y, {"line": line(y, light), "ambient": line(y, light, ambient), HAND_BUILT: terms(y, lagged, [0.1, 900.0])}
