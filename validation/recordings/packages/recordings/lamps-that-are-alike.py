"""Light of a dark red lamp over that of another of its kind, 64 settings of both."""

from readers.pysilsub import lamp_models, two_lamps

HAND_BUILT = "line"


def rows(*contents):
    return two_lamps(*contents, number=9)


models = lamp_models
