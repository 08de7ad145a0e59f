"""Dust below ten micrometres over that below two and a half, two months of a town. What is coarse is stirred up by people and wheels by day."""

from durations import DAY
from models.cycles import tone
from models.fitting import line, terms
from models.lags import lag, moved
from readers.aeroviz import air_station

HAND_BUILT = "day that is shifted"


def rows(content):
    read = air_station(content, "PM2.5", "PM10", "WS", "RH")
    return {"time_s": read.time_s, "fine_ug_m3": read["PM2.5"], "all_ug_m3": read.PM10, "wind_m_s": read.WS, "humidity_pct": read.RH}


def models(c):
    y, x, t, wind, damp = c["all_ug_m3"], c["fine_ug_m3"], c["time_s"], c["wind_m_s"], c["humidity_pct"]
    day = [*tone(t, DAY), *tone(t, DAY / 2)]
    return y, {
        "line": line(y, x),
        "square": line(y, x, x**2),
        "drift": line(y, x, t),
        "wind": line(y, x, wind),
        "slope by wind": line(y, x, wind, x * wind),
        "damp": line(y, x, damp),
        "day": line(y, x, *tone(t, DAY)),
        "day, and half of it": line(y, x, *day),
        "day, and wind": line(y, x, *day, wind),
        "day, and damp": line(y, x, *day, damp),
        "day, and drift": line(y, x, *day, t),
        "day, and slope by it": line(y, x, *day, x * day[0], x * day[1]),
        "day that is shifted": terms(y, lambda p: [moved(x, t, p[0] * 3600), *day], [-0.3]),
        "day, and lag": terms(y, lambda p: [x, lag(x, t, abs(p[0]) * 3600), *day], [1.0]),
    }
