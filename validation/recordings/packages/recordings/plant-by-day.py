"""One instrument of a plant over another that goes with it, eleven days. Their difference goes with the time of day."""

from readers.bibmon import instrument_models, plant_tags

HAND_BUILT = "day"


def rows(content):
    return plant_tags(content, first="tag90", second="tag98")


def models(c):
    return instrument_models(c)
