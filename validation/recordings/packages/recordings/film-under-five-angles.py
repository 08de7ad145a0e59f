"""One angle of an ellipsometer, psi, over the other, delta, 32 spots of a film at five angles of light, means of four zones. Where the film is thicker both move along a curve, which is another at each angle."""

from models.drivers import of_drivers
from models.fitting import line, scaled
from readers.refellips import zones

HAND_BUILT = "all cubes"


def rows(content):
    told = zones(content)[0]
    return {"delta_deg": told.delta, "angle_deg": told.angle, "psi_deg": told.psi}


def models(c):
    y, x, angle = c["psi_deg"], c["delta_deg"], c["angle_deg"]
    u, v = scaled(x), scaled(angle)
    squares, cubes = [u, v, u**2, u * v, v**2], [u**3, u**2 * v, u * v**2, v**3]
    return y, {**of_drivers(y, x, angle=angle), "slope and square by angle": line(y, *squares, u**2 * v), "all cubes": line(y, *squares, *cubes)}
