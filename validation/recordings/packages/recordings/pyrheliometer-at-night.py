"""What a pyrheliometer tells at night, when there is no sun, nineteen days of March, every fifth minute, with the temperature of the air. Its body is behind the air."""

from models.fitting import line, terms
from models.lags import lag
from readers.libinsitu import clock_from_first_row, radiation

HAND_BUILT = "temperature, and late temperature"


def rows(content):
    frame = radiation(content, "2020-03-01", "2020-03-20")
    frame = clock_from_first_row(frame[(frame["global"] < 0) & (frame.diffuse < 0) & (frame.direct < 3)].iloc[::5])
    return {"time_s": frame.time_s, "air_c": frame.air_c, "beam_w_m2": frame.direct}


def models(c):
    y, air, t = c["beam_w_m2"], c["air_c"], c["time_s"]
    late = lambda p: lag(air, t, abs(p) * 600)
    return y, {
        "constant": line(y),
        "drift": line(y, t),
        "temperature": line(y, air),
        "temperature, bent": line(y, air, air**2),
        "temperature, and drift": line(y, air, t),
        "late temperature": terms(y, lambda p: [late(p[0])], [1.0]),
        HAND_BUILT: terms(y, lambda p: [air, late(p[0])], [3.0]),
    }
