"""Heat flow of an empty calorimeter while it is heated to 800 degC, two weeks after the same programme, every sixth reading; the simulation is the run before. The sensor is another one when it is hot."""

from models.fitting import line
from readers.pyngb import programme_twice

HAND_BUILT = "temperature, bent"


def rows(first, second):
    one, two = programme_twice(first, second, 6)
    return {"time_s": two.minutes * 60, "first_uv": one.heat_flow_uv.to_numpy(), "second_uv": two.heat_flow_uv, "sample_c": two.sample_c}


def models(c):
    y, x, t, degrees = c["second_uv"], c["first_uv"], c["time_s"], c["sample_c"]
    return y, {
        "line": line(y, x),
        "square": line(y, x, x**2),
        "drift": line(y, x, t),
        "temperature": line(y, x, degrees),
        HAND_BUILT: line(y, x, degrees, degrees**2),
        "temperature and drift": line(y, x, degrees, t),
        "gain by temperature": line(y, x, degrees * x),
    }
