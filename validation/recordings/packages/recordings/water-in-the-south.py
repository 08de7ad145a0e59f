"""A ship takes in water: how warm it is in the laboratory over how warm it was in the sea, beside its salt, twelve days from the equator to the south."""

from readers.fluxengine import cruise
from readers.fluxengine import water_models as models

HAND_BUILT = "square"


def rows(content):
    return cruise(content, 1500, 3000, sea_degc="temperature", salt="salinity", laboratory_degc="temperature_eq")
