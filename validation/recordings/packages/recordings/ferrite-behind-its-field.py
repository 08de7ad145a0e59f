"""Angle by which the flux in a ring of ferrite is behind its field, over the flux: runs at four warmths and five frequencies. What is lost in a wave grows with the frequency."""

from models.drivers import of_drivers
from models.fitting import line, scaled
from readers.materialdatabase import ferrite

HAND_BUILT = "square, slope by frequency, and square by it"


def rows(content):
    return ferrite(content, "N49", least=0.001)


def models(c):
    y, x, frequency = c["angle_deg"], c["flux_t"], c["frequency_khz"]
    u, v = scaled(x), scaled(frequency)
    return y, {
        **of_drivers(y, x, frequency=frequency),
        "slope by frequency alone": line(y, x, u * v),
        "slope by frequency, and by its square": line(y, x, v, u * v, v**2, u * v**2),
        "square, slope by frequency, and square by it": line(y, x, u**2, v, u * v, u**2 * v),
    }
