"""Power to the stirrer of a dryer over what is called its speed: thirty batches. A stirrer takes speed times torque."""

from models.drivers import of_drivers
from models.fitting import line, scaled
from readers.process_improve import dryer_batches

HAND_BUILT = "cube, all squares, and square by torque"


def rows(content):
    frame = dryer_batches(content, 1, 30)
    return {"run": frame.batch_id, "speed": frame.AgitatorSpeed, "torque": frame.AgitatorTorque, "power": frame.AgitatorPower}


def models(c):
    y, x, torque = c["power"], c["speed"], c["torque"]
    u, v = scaled(x), scaled(torque)
    return y, {
        **of_drivers(y, x, torque=torque),
        "slope by torque alone": line(y, u, u * v),
        "cube, and slope by torque": line(y, u, u**2, u**3, v, u * v),
        "square, and square by torque": line(y, u, u**2, v, u * v, u**2 * v),
        "cube, and square by torque": line(y, u, u**2, u**3, v, u * v, u**2 * v),
        "cube, all squares, and square by torque": line(y, u, u**2, u**3, v, v**2, u * v, u**2 * v),
    }
