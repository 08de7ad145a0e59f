"""How much a fan shakes that airs a building, thirty days in spring: it stands at night, and runs at one of two speeds by day."""

from readers.skchange import fan
from readers.skchange import fan_models as models

HAND_BUILT = "eight waves a day"


def rows(content):
    return fan(content, 0)
