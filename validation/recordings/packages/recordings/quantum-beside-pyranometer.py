"""Light for plants by a quantum sensor over the sunshine of a pyranometer beside it, three weeks of spring, a row each half hour. Both tell the same sun."""

from models.fitting import line, terms
from models.lags import lag, usual
from readers.soil_heat import half_hours

HAND_BUILT = "a part late"


def rows(content):
    frame = half_hours(content, "SW_IN", "PPFD_IN")
    return {"time_s": frame.time_s, "sunshine_w_m2": frame.SW_IN, "light_umol_m2_s": frame.PPFD_IN}


def models(c):
    y, x, t = c["light_umol_m2_s"], c["sunshine_w_m2"], c["time_s"]
    return y, {
        **usual(y, x, t, 600),
        "cubic": line(y, x, x**2, x**3),
        HAND_BUILT: terms(y, lambda p: [x, lag(x, t, abs(p[0]) * 600)], [1.0]),
    }
