"""A living cell under the tip of a force microscope: pressed in within a second, held at one height for half a minute, let go. The deflection of the cantilever fades while it is held.

The height is the travel by the strain gauge of the stage, 10 um/V by its calibration; the tip is in touch, and pulled, when the recording begins.
"""

import numpy as np
from models.fitting import line, terms
from models.lags import lag
from readers.afmformats import jpk

HAND_BUILT = "two times"


def rows(content):
    t, height, volts, begin = [], [], [], 0.0
    for duration, channels in jpk(content):
        n = len(channels["vDeflection"])
        kept = slice(0, n, 8 if n < 5000 else 24)
        t.append(begin + (np.arange(n) * duration / n)[kept])
        height.append(channels["strainGaugeHeight"][kept])
        volts.append(channels["vDeflection"][kept])
        begin += duration
    t, height, volts = map(np.concatenate, (t, height, volts))
    return {"time_s": t.round(6), "height_um": (height - height[0]) * 10, "deflection_v": volts}


def models(c):
    y, x, t = c["deflection_v"], c["height_um"], c["time_s"]
    u = x / np.ptp(x)

    def fades(p):
        return [u - lag(u, t, abs(tau)) for tau in p]

    return y, {
        "line": line(y, x),
        "cubic": line(y, u, u**2, u**3),
        "one time": terms(y, lambda p: [u, *fades(p)], [3.0]),
        HAND_BUILT: terms(y, lambda p: [u, *fades(p)], [1.0, 8.0]),
        "square, and two times": terms(y, lambda p: [u, u**2, *fades(p)], [1.0, 8.0]),
        "cubic, and three times": terms(y, lambda p: [u, u**2, u**3, *fades(p)], [0.3, 2.0, 8.0]),
    }
