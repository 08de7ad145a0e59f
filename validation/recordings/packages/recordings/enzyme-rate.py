"""Rate of an enzyme over its substrate, with and without puromycin: it levels off, and the treated cells are quicker."""

from models.fitting import line, terms, through_zero
from readers.rdatasets import frame

HAND_BUILT = "Michaelis and Menten, treated quicker"


def rows(content):
    d = frame(content)
    return {"substrate_ppm": d.conc, "treated": (d.state == "treated") * 1, "rate": d.rate}


def models(c):
    y, x, treated = c["rate"], c["substrate_ppm"], c["treated"]
    one = terms(y, lambda p: [x / (abs(p[0]) + x)], [0.06], through_zero)
    both = terms(y, lambda p: [x / (abs(p[0]) + x), treated * x / (abs(p[0]) + x)], [0.06], through_zero)
    return y, {"line": line(y, x), "Michaelis and Menten": one, HAND_BUILT: both}
