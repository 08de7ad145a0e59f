"""Length that a dilatometer shows while its own rods are heated to 900 degC, the run by which it is corrected, every sixth reading. One rod warms before the other."""

from models.fitting import line, terms
from models.lags import lag
from readers.pyngb import thermal_analysis

HAND_BUILT = "late temperature"


def rows(content):
    frame = thermal_analysis(content, run=1).iloc[::6]
    return {"time_s": frame.minutes * 60, "length_um": frame.length_um, "sample_c": frame.sample_c}


def models(c):
    y, degrees, t = c["length_um"], c["sample_c"], c["time_s"]
    late = lambda p: lag(degrees, t, abs(p[0]) * 600)
    return y, {
        "constant": line(y),
        "drift": line(y, t),
        "temperature": line(y, degrees),
        "temperature, bent": line(y, degrees, degrees**2),
        "temperature, and drift": line(y, degrees, t),
        HAND_BUILT: terms(y, lambda p: [late(p)], [0.2]),
        "late temperature, bent": terms(y, lambda p: [late(p), late(p) ** 2], [0.2]),
        "temperature and late temperature": terms(y, lambda p: [degrees, late(p)], [1.0]),
    }
