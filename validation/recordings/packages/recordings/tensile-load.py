"""Load of a specimen of plastic over its strain while it is pulled, up to shortly before it breaks, each 0.06 s. It yields, and then gets thinner."""

from models.bends import bends
from readers.pyfat import pulled_specimen

HAND_BUILT = "soft bend"


def rows(content):
    frame = pulled_specimen(content)
    return {"time_s": frame.time_s, "strain_pct": frame.strain_pct, "load_kn": frame.load_kn}


def models(c):
    return c["load_kn"], bends(c["load_kn"], c["strain_pct"])
