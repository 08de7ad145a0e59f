"""Sun of the whole sky over that of the shaded sky while clouds hide the sun, nineteen days of March, every second minute. Both see the same."""

from models.cycles import tone
from models.fitting import line
from models.lags import usual
from readers.libinsitu import clock_from_first_row, radiation

HAND_BUILT = "gain by temperature"


def rows(content):
    frame = radiation(content, "2020-03-01", "2020-03-20")
    frame = clock_from_first_row(frame[(frame["global"] > 20) & (frame.direct < 2)].iloc[::2])
    return {"time_s": frame.time_s, "air_c": frame.air_c, "shaded_w_m2": frame.diffuse, "whole_w_m2": frame["global"]}


def models(c):
    y, x, t, air = c["whole_w_m2"], c["shaded_w_m2"], c["time_s"], c["air_c"]
    return y, {
        **usual(y, x, t),
        "temperature": line(y, x, air),
        HAND_BUILT: line(y, x, x * air),
        "day": line(y, x, *tone(t, 86400)),
    }
