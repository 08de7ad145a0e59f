"""Water in the pores of rock that neutrons tell, over that which its density tells, each second foot of a well, and the gamma rays of clay. Clay has water that is not in pores."""

from formats.las import well_log
from models.drivers import of_drivers

HAND_BUILT = "square, and gamma"


def rows(content):
    told = well_log(content).iloc[::4]
    return {"density_share": told.DPHI, "gamma_gapi": told.GR, "neutron_share": told.NPHI}


def models(c):
    y, x = c["neutron_share"], c["density_share"]
    return y, of_drivers(y, x, gamma=c["gamma_gapi"])
