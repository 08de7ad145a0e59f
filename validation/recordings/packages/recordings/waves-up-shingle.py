"""How high waves run up a beach of small stones in Cornwall over how high they are, 324 times. Where it is steep they run higher, by more the higher they are."""

from models.drivers import gains, of_drivers
from models.fitting import line, scaled
from readers.py_wave_runup import runup

HAND_BUILT = "slope by slope"


def rows(content):
    told = runup(content, "LOEBAR")
    return {name: told[name] for name in ("height_m", "slope", "runup_m")}


def models(c):
    y, x, slope = c["runup_m"], c["height_m"], c["slope"]
    u, v = scaled(x), scaled(slope)
    return y, {
        **of_drivers(y, x, slope=slope),
        **gains(y, x, slope=slope),
        "height times slope": line(y, x * slope),
        "gain by slope, bent": line(y, x, x * v, x * v**2),
        "gain by slope, and square": line(y, x, u**2, x * v),
    }
