"""Water in the air by an infrared gas analyser over that by a humidity probe on the same mast, beside the temperature of the air, eight days of spring, a row each half hour. Gain and offset apart they agree, to some daily difference."""

from models.cycles import tone
from models.fitting import line
from models.lags import usual
from readers.micromet import tob1

HAND_BUILT = "day"


def rows(content):
    frame = tob1(content)
    return {"time_s": frame.time_s, "probe_g_m3": frame.H2O_probe, "air_c": frame.TA_3_1_1, "analyser_g_m3": frame.H2O_density}


def models(c):
    y, x, t, warm = c["analyser_g_m3"], c["probe_g_m3"], c["time_s"], c["air_c"]
    return y, {
        **usual(y, x, t, 3600),
        "temperature": line(y, x, warm),
        "gain by temperature": line(y, x, x * warm),
        HAND_BUILT: line(y, x, *tone(t, 86400)),
    }
