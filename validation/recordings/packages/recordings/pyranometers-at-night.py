"""What a pyranometer tells at night over what the shaded one beside it tells, nineteen days of March, every fifth minute, with the temperature of the air. Both are cooled by the sky."""

from models.fitting import line, terms
from models.lags import lag, usual
from readers.libinsitu import clock_from_first_row, radiation

HAND_BUILT = "lag, and temperature"


def rows(content):
    frame = radiation(content, "2020-03-01", "2020-03-20")
    frame = clock_from_first_row(frame[(frame["global"] < 0) & (frame.diffuse < 0) & (frame.direct < 3)].iloc[::5])
    return {"time_s": frame.time_s, "air_c": frame.air_c, "shaded_w_m2": frame.diffuse, "whole_w_m2": frame["global"]}


def models(c):
    y, x, t, air = c["whole_w_m2"], c["shaded_w_m2"], c["time_s"], c["air_c"]
    late = lambda p: lag(x, t, abs(p) * 600)
    return y, {
        **usual(y, x, t, 600),
        "temperature": line(y, x, air),
        "gain by temperature": line(y, x, x * air),
        "line and lag": terms(y, lambda p: [x, late(p[0])], [1.0]),
        HAND_BUILT: terms(y, lambda p: [late(p[0]), air], [1.0]),
        "lag, and drift": terms(y, lambda p: [late(p[0]), t], [1.0]),
    }
