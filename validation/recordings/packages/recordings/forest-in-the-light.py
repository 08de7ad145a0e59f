"""What the air gives to a forest over the light on it, sorted by the light. Leaves are full of light at last; where it comes from all sides more of them have some."""

import numpy as np
from models.drivers import of_drivers
from models.fitting import line, scaled, terms
from readers.cdt import pair_columns

HAND_BUILT = "saturation, and diffuse"


def rows(content):
    return pair_columns(content, diffuse_umol_m2_s=("pair74", "A"), light_umol_m2_s=("pair73", "A"), uptake_umol_m2_s=("pair73", "B"))


def models(c):
    y, x, diffuse = c["uptake_umol_m2_s"], c["light_umol_m2_s"], c["diffuse_umol_m2_s"]
    u, v, full = scaled(x), scaled(diffuse), lambda p: x / (x + abs(p) * 500)
    return y, {
        **of_drivers(y, x, diffuse=diffuse),
        "logarithm": line(y, x, np.log(x)),
        "saturation": terms(y, lambda p: [full(p[0])], [1.0]),
        "saturation, and diffuse": terms(y, lambda p: [full(p[0]), v], [1.0]),
        "saturation, and slope by diffuse": terms(y, lambda p: [full(p[0]), v, u * v], [1.0]),
        "end of the scale": terms(y, lambda p: [np.minimum(x, abs(p[0]) * 1000)], [1.0]),
        "end of the scale, and diffuse": terms(y, lambda p: [np.minimum(x, abs(p[0]) * 1000), v], [1.0]),
        "cube, and diffuse": line(y, x, u**2, u**3, v),
        "cube, and slope by diffuse": line(y, x, u**2, u**3, v, u * v),
        "slope by diffuse alone": line(y, x, u * v),
    }
