"""Light of a dark red lamp over that of another of its kind, 64 settings of both."""

from tellers import of_two_lamps, two_lamps

HAND_BUILT = "line"


def rows(*contents):
    return two_lamps(*contents, number=9)


models = of_two_lamps
