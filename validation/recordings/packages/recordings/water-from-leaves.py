"""Heat that goes up with vapour, as an anemometer and a gas analyser at a tower told it, over what its radiometer told that the ground keeps of the sun, 1065 times at many towers. Leaves give off water; bare ground does not."""

from models.drivers import of_drivers
from models.fitting import line
from readers.ecov002_calval_tables import towers

HAND_BUILT = "all squares of green"


def rows(content):
    read = towers(content, "NETRAD_filt", "NDVI", "LE_filt")
    return {"radiation_w_m2": read.NETRAD_filt, "green": read.NDVI, "vapour_w_m2": read.LE_filt}


def models(c):
    y, x, green = c["vapour_w_m2"], c["radiation_w_m2"] / 100, c["green"]
    return y, {**of_drivers(y, x, green=green), "product alone": line(y, x, x * green)}
