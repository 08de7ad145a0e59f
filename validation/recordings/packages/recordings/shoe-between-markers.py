"""How fast a foot pitches by a gyroscope on the shoe over how fast markers at heel and toe do, while somebody walks up and down. The gyroscope sits askew, and toes bend."""

from models.drivers import of_drivers
from models.fitting import line, terms
from models.lags import moved, usual_and_shifts
from readers.gaitmap import foot_pitch

HAND_BUILT = "shift, cube, and twist"


def rows(markers, sensors):
    return foot_pitch(markers, sensors, "left")


def models(c):
    y, x, twist, t = c["gyro"], c["markers"], c["twist"], c["time_s"]
    u, v = x / x.std(), twist / twist.std()
    at = lambda p: moved(u, t, p[0] * 0.01)
    return y, {
        **of_drivers(y, x, twist=twist),
        **usual_and_shifts(y, x, t, 0.01, twist=twist),
        "fifth power": line(y, u, u**2, u**3, u**4, u**5),
        "cube, and twist": line(y, u, u**2, u**3, v),
        "cube, and slope by twist": line(y, u, u**2, u**3, v, u * v),
        "shift, and cube": terms(y, lambda p: [at(p), at(p) ** 2, at(p) ** 3], [-0.2]),
        "shift, cube, and twist": terms(y, lambda p: [at(p), at(p) ** 2, at(p) ** 3, v], [-0.2]),
        "shift, cube, and slope by twist": terms(y, lambda p: [at(p), at(p) ** 2, at(p) ** 3, v, at(p) * v], [-0.2]),
    }
