"""Difference of air pressure between Easter Island and Darwin, month by month: a yearly cycle. The two longer tones of NIST predict worse."""

from formats.nist import nist
from models.cycles import tone
from models.fitting import line, terms

HAND_BUILT = "year"
MONTH = 30.4375  # d


def rows(content):
    d = nist(content, ["pressure_difference", "month"])
    return {"time_d": d["month"] * MONTH, "pressure_difference": d["pressure_difference"]}


def models(c):
    y, month = c["pressure_difference"], c["time_d"] / MONTH
    three = terms(y, lambda p: [*tone(month, 12), *tone(month, p[0]), *tone(month, p[1])], [44.3, 26.9])
    return y, {"constant": line(y), HAND_BUILT: line(y, *tone(month, 12)), "three tones (NIST)": three}
