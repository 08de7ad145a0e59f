"""Steam that a plant uses in a month over the temperature outside: the days at work count as well."""

from models.fitting import line
from readers.rdatasets import frame

HAND_BUILT = "days at work"


def rows(content):
    d = frame(content)
    return {"outside_c": (d.temperature - 32) / 1.8, "days_at_work": d["op.days"], "glycerine_lb": d.glycerine, "wind_mph": d.wind, "steam_lb": d.Steam}


def models(c):
    y, outside, days = c["steam_lb"], c["outside_c"], c["days_at_work"]
    return y, {"line": line(y, outside), HAND_BUILT: line(y, outside, days), "and glycerine": line(y, outside, days, c["glycerine_lb"])}
