"""Two voltage inputs of a logger at steps of less than a millivolt, 45 s. They agree."""

from readers.rocketlogger import alike_models, side_by_side

HAND_BUILT = "line"
LABELS = ("first_mv", "second_mv")


def rows(content):
    return side_by_side(content, "V1", "V2", 1e-3, LABELS)


def models(c):
    return c["second_mv"], alike_models(c["second_mv"], c["first_mv"], c["time_s"])
