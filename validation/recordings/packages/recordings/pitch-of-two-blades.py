"""Angle at which one blade of a wind turbine is set over that of another, ten minutes in which both go to and fro between two angles. It has play, and is set to another zero towards the end."""

from models.fitting import line, terms
from models.jumps import soft_step
from models.lags import play, usual_and_lags
from readers.wetb import turbine_sensors

HAND_BUILT = "play, step, and another slope"


def rows(content):
    read = turbine_sensors(content)
    return {"time_s": read["time_s"], "first_deg": read["Pitch_A"], "second_deg": read["Pitch_B"]}


def models(c):
    y, x, t = c["second_deg"], c["first_deg"], c["time_s"]
    after = lambda p: soft_step(t, p * 100, 2)
    loose = lambda p: play(x, abs(p) * 0.1)
    return y, {
        **usual_and_lags(y, x, t, 5),
        "cube": line(y, x, x**2, x**3),
        "square, and drift": line(y, x, x**2, t),
        "square, drift, and its square": line(y, x, x**2, t, t**2),
        "step": terms(y, lambda p: [x, after(p[0])], [4.5]),
        "step, and another slope after it": terms(y, lambda p: [x, after(p[0]), after(p[0]) * x], [4.5]),
        "play": terms(y, lambda p: [loose(p[0])], [0.5]),
        "play, and square": terms(y, lambda p: [loose(p[0]), x**2], [0.5]),
        "play, and drift": terms(y, lambda p: [loose(p[0]), t], [0.5]),
        "play, square, and drift": terms(y, lambda p: [loose(p[0]), x**2, t], [0.5]),
        "play, square, and step": terms(y, lambda p: [loose(p[0]), x**2, after(p[1])], [0.5, 4.5]),
        "play, and step": terms(y, lambda p: [loose(p[0]), after(p[1])], [0.5, 4.5]),
        "play, step, and another slope": terms(y, lambda p: [loose(p[0]), after(p[1]), after(p[1]) * x], [0.5, 4.5]),
        "play, and line": terms(y, lambda p: [loose(p[0]), x], [0.5]),
    }
