"""How much a fan shakes that airs a building while it runs at the lower of two speeds, thirty days in spring."""

from readers.skchange import fan
from readers.skchange import fan_models as models

HAND_BUILT = "two waves a day"


def rows(content):
    return fan(content, 0, 0.03, 0.2)
