"""A star in one field of a camera over that in another one, of exposures within 43 minutes, while another star passes before it and makes it brighter."""

from durations import DAY
from models.bends import bends_with
from models.cycles import tone
from models.fitting import line, scaled
from readers.mulensmodel import two_fields

HAND_BUILT = "as it is"


def rows(first, second):
    return two_fields(first, second, apart=2592, worst=0.15)


def models(c):
    y, x, t = c["second_mag"], c["first_mag"], c["time_s"]
    return y, {
        "as it is": lambda seen: x,
        **bends_with(y, x, drift=scaled(t)),
        "day": line(y, x, *tone(t, DAY)),
    }
