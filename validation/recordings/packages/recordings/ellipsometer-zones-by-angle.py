"""What an ellipsometer tells of a film with its polarisers in one of four zones over another, 32 spots at five angles. Errors of its parts show in each zone with another sign."""

from models.drivers import of_drivers
from models.fitting import line
from readers.refellips import zones

HAND_BUILT = "angle"


def rows(content):
    told = zones(content)
    return {"angle_deg": told[2].angle, "second_zone_deg": told[2].psi, "fourth_zone_deg": told[4].psi}


def models(c):
    y, x, angle = c["fourth_zone_deg"], c["second_zone_deg"], c["angle_deg"] / 10
    return y, {**of_drivers(y, x, angle=angle), "slope by angle alone": line(y, x, x * angle)}
