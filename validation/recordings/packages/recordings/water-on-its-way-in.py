"""A ship takes in water: how warm it is in the laboratory over how warm it was in the sea, beside its salt, twelve days from off Biscay to the equator."""

from readers.fluxengine import cruise
from readers.fluxengine import water_models as models

HAND_BUILT = "line"


def rows(content):
    return cruise(content, 0, 1500, sea_degc="temperature", salt="salinity", laboratory_degc="temperature_eq")
