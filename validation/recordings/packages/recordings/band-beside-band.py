"""How much light of 1085 1/cm a broth takes away over that of 1080 1/cm, 34 h of a fermentation. Both lie in the same band."""

from durations import HOUR
from models.fitting import line, scaled
from models.lags import usual
from readers.chemotools import bands

HAND_BUILT = "step"


def rows(content):
    return bands(content, 75, 1080, 1085)


def models(c):
    y, x, t = c["band_1085"], c["band_1080"], c["time_s"]
    u, v = scaled(x), scaled(t)
    return y, {
        **usual(y, x, t, HOUR),
        "cube": line(y, x, u**2, u**3),
        "drift, and its square": line(y, x, v, v**2),
        "slope that drifts": line(y, x, v, u * v),
        "step": line(y, x, t > 16.7 * HOUR),
    }
