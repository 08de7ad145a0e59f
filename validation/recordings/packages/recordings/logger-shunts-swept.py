"""Two inputs for current of a logger in series while they are calibrated from one end of their range to the other and back, as numbers of the converter. One reads a little more on the way back."""

from readers.rocketlogger import alike_models, side_by_side

HAND_BUILT = "step"
LABELS = ("first_kcounts", "second_kcounts")


def rows(content):
    return side_by_side(content, "I1H", "I2H", 1e3, LABELS)


def models(c):
    return c["second_kcounts"], alike_models(c["second_kcounts"], c["first_kcounts"], c["time_s"])
