"""What an accelerometer feels along a car over how much faster the car gets. On a slope it feels a part of its weight as well."""

from models.drivers import of_drivers
from models.fitting import line, scaled, terms
from models.lags import moved
from readers.pntos_cobra_datasets_lcm import drive_by_force

HAND_BUILT = "slope"


def rows(content):
    return drive_by_force(content, 3.0)


def models(c):
    y, x, t, slope = c["felt_m_s2"], c["gained_m_s2"], c["time_s"], c["slope"]
    u, w, v = scaled(x), scaled(t), scaled(slope)
    return y, {
        **of_drivers(y, x, slope=slope),
        "drift": line(y, x, w),
        "slope, and drift": line(y, x, v, w),
        "slope, drift, and its square": line(y, x, v, w, w**2),
        "slope, and shift": terms(y, lambda p: [moved(x, t, p[0]), v], [0.1]),
        "slope a while earlier": terms(y, lambda p: [x, moved(slope, t, p[0])], [0.1]),
        "slope, and cube": line(y, x, u**2, u**3, v),
    }
