"""Light of a cyan lamp over that of another of its kind, 64 settings of both. The brighter both are, the more it falls behind."""

from readers.pysilsub import lamp_models, two_lamps

HAND_BUILT = "power"


def rows(*contents):
    return two_lamps(*contents, number=4)


models = lamp_models
