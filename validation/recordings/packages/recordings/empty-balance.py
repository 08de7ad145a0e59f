"""Weight that an empty thermobalance shows while its furnace is heated to 800 degC and held, every sixth reading. Warm gas bears less, and draws along."""

from models.fitting import line, terms
from models.lags import lag
from readers.pyngb import thermal_analysis

HAND_BUILT = "density and temperature"


def rows(content):
    frame = thermal_analysis(content).iloc[::6]
    return {"time_s": frame.minutes * 60, "mass_mg": frame.mass_mg, "sample_c": frame.sample_c}


def models(c):
    y, degrees, t = c["mass_mg"], c["sample_c"], c["time_s"]
    late = lambda p: lag(degrees, t, abs(p[0]) * 600)
    return y, {
        "constant": line(y),
        "drift": line(y, t),
        "temperature": line(y, degrees),
        "temperature, and drift": line(y, degrees, t),
        "temperature, bent": line(y, degrees, degrees**2),
        "bent, and drift": line(y, degrees, degrees**2, t),
        "late temperature": terms(y, lambda p: [late(p)], [1.0]),
        "late temperature, bent": terms(y, lambda p: [late(p), late(p) ** 2], [0.1]),
        "temperature and late temperature": terms(y, lambda p: [degrees, late(p)], [1.0]),
        "density of the gas": line(y, 298 / (degrees + 273)),
        HAND_BUILT: line(y, 298 / (degrees + 273), degrees),
    }
