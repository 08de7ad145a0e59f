"""One instrument of a plant over another beside it, eleven days. One goes with the day, and on the eighth it comes to tell more."""

from readers.bibmon import instrument_models, plant_tags

HAND_BUILT = "day, and step"


def rows(content):
    return plant_tags(content, first="tag26", second="tag31")


def models(c):
    return instrument_models(c)
