"""Voltage of a nerve cell, from 40 ms before a current through it is stepped up by 37 pA until shortly before its first spike, 4000 rows a second. Its skin is a capacitor."""

from readers.bluepyefe import cell_models, cell_voltage

HAND_BUILT = "two lags beside each other"


def rows(current, voltage):
    return cell_voltage(current, voltage, 2650, 3100)


def models(c):
    return cell_models(c, HAND_BUILT)
