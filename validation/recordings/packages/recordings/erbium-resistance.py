"""Resistance of an erbium film over its temperature, cooled six times, each time in another field, every second row. Where it orders it is bent, and the field moves that."""

from formats.clock import since_first
from formats.multivu import multivu
from models.fitting import line

HAND_BUILT = "cubic, and field"


def rows(content):
    frame = multivu(content).iloc[::2]
    names = {"film_k": "Temperature (K)", "field_koe": "Magnetic Field (Oe)", "resistance_ohm": "Bridge 1 Resistivity (Ohm)"}
    columns = {name: frame[column] for name, column in names.items()}
    return {"time_s": since_first(frame["Time Stamp (sec)"]), **columns, "field_koe": columns["field_koe"] / 1000}


def models(c):
    y, x, field, t = c["resistance_ohm"], c["film_k"], c["field_koe"], c["time_s"]
    return y, {
        "line": line(y, x),
        "cubic": line(y, x, x**2, x**3),
        "field": line(y, x, field, field * x),
        "drift": line(y, x, t),
        HAND_BUILT: line(y, x, x**2, x**3, field, field * x),
    }
