"""Sun that one pyranometer above a beech forest tells over that of another beside it, seven weeks of summer, a row each half hour, with net radiation. The sky cools the one more than the other."""

from models.fitting import line
from models.lags import usual
from readers.hesseflux import tower

HAND_BUILT = "net radiation, and square"


def rows(content):
    frame = tower(content, "2016-06-25", "2016-08-15", "SW_IN_1_1_1", "SW_IN_1_1_2", "NETRAD_1_1_1", "TA_1_1_1")
    return {"time_s": frame.time_s, "air_c": frame.TA_1_1_1, "net_w_m2": frame.NETRAD_1_1_1, "first_w_m2": frame.SW_IN_1_1_1, "second_w_m2": frame.SW_IN_1_1_2}


def models(c):
    y, x, t, net, air = c["second_w_m2"], c["first_w_m2"], c["time_s"], c["net_w_m2"], c["air_c"]
    return y, {
        **usual(y, x, t, 3600),
        "temperature": line(y, x, air),
        "net radiation": line(y, x, net),
        HAND_BUILT: line(y, x, x**2, net),
        "net radiation, and temperature": line(y, x, net, air),
    }
