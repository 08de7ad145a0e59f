"""Voltage of a nerve cell, from 20 ms after its last spike, while a current through it is stepped down by 37 pA, until the end of the sweep, 4000 rows a second. Its skin is a capacitor."""

from readers.bluepyefe import cell_models, cell_voltage

HAND_BUILT = "two lags beside each other"


def rows(current, voltage):
    return cell_voltage(current, voltage, 10560, 12000)


def models(c):
    return cell_models(c, HAND_BUILT)
