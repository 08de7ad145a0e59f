"""Neutrons that the same counter counts in an hour, 110 days of a winter, beside the pressure. Water in the ground, which no column tells, comes and goes."""

from models.fitting import line
from readers.neptoon import muon_counter

HAND_BUILT = "pressure"


def rows(content):
    frame = muon_counter(content)
    return {"time_s": frame.time_s, "neutrons": frame.neutrons, "pressure_hpa": frame.pressure}


def models(c):
    y, p, t = c["neutrons"], c["pressure_hpa"], c["time_s"]
    return y, {
        "constant": line(y),
        HAND_BUILT: line(y, p),
        "pressure, bent": line(y, p, (p - 985) ** 2),
        "drift": line(y, t),
        "pressure and drift": line(y, p, t),
    }
