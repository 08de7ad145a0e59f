"""Air that somebody breathes over the carbon dioxide that comes with it, as the work grows until it is too much. At last the blood is sour, and breath grows beyond the gas."""

from models.bends import corner
from models.fitting import line, scaled, terms
from models.lags import lag, usual_and_shifts
from readers.pyoxynet import exercise

HAND_BUILT = "cube"


def rows(content):
    return exercise(content, 3, carbon_dioxide_ml_min="VCO2_I", breath_l_min="VE_I")


def models(c):
    y, x, t = c["breath_l_min"], c["carbon_dioxide_ml_min"], c["time_s"]
    u, w, late = scaled(x), scaled(t), lambda p: lag(x, t, abs(p) * 20)
    bend = lambda p: (late(p[0]), scaled(late(p[0])) ** 2, scaled(late(p[0])) ** 3)
    return y, {
        **usual_and_shifts(y, x, t, 20),
        "cube": line(y, x, u**2, u**3),
        "fourth power": line(y, x, u**2, u**3, u**4),
        "corner": corner(y, x / 1000, 3.0),
        "drift, and slope that drifts": line(y, x, w, u * w),
        "cube, and drift": line(y, x, u**2, u**3, w),
        "cube, drift, and slope that drifts": line(y, x, u**2, u**3, w, u * w),
        "cube, and lag": terms(y, bend, [0.3]),
        "line, and lag": terms(y, lambda p: [x, late(p[0])], [1.0]),
    }
