"""Temperature of the air by the speed of sound over that of a shielded probe on one mast, beside the water in the air and the sun, 17 days of March, a row each half hour. Sound is faster in damp air; the probe's shield warms in the sun."""

from models.cycles import tone
from models.fitting import line
from models.lags import usual
from readers.soil_heat import half_hours

HAND_BUILT = "vapour, and sunshine, and drift"


def rows(content):
    frame = half_hours(content, "T_SONIC", "TA_1_1_3", "H2O", "SW_IN")
    return {"time_s": frame.time_s, "probe_c": frame.TA_1_1_3, "vapour_g_m3": frame.H2O, "sunshine_w_m2": frame.SW_IN, "sonic_c": frame.T_SONIC}


def models(c):
    y, x, t, vapour, sun = c["sonic_c"], c["probe_c"], c["time_s"], c["vapour_g_m3"], c["sunshine_w_m2"]
    return y, {
        **usual(y, x, t, 3600),
        "vapour": line(y, x, vapour),
        "sunshine": line(y, x, sun),
        "day": line(y, x, *tone(t, 86400)),
        "vapour, and sunshine": line(y, x, vapour, sun),
        "vapour, and sunshine, and square": line(y, x, x**2, vapour, sun),
        HAND_BUILT: line(y, x, vapour, sun, t),
    }
