"""How fast a heart beats over the oxygen that is taken up, as the work grows until it is too much. It comes to beat faster for the same oxygen."""

from readers.pyoxynet import exercise, heart_models

HAND_BUILT = "drift"


def rows(content):
    return exercise(content, 3, oxygen_ml_min="VO2_I", heart_per_min="HR_I")


def models(c):
    return heart_models(c)
