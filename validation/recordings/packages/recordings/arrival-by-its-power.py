"""When radio of one station comes in over when that of another does, in m, beside how strong the one is: what is near is strong. A receiver that is carried through a hall, 19 minutes."""

from models.drifts import usual_shifts_and_drifts
from models.drivers import drivers_and_drift, of_drivers
from models.fitting import line, scaled
from readers.pnt_datasets import pair

HAND_BUILT = "power"


def rows(content):
    columns = pair(content, 1, 2)
    return {name: columns[name] for name in ("time_s", "first_m", "second_dbm", "second_m")}


def models(c):
    y, x, t, z = c["second_m"], c["first_m"], c["time_s"], c["second_dbm"]
    v = scaled(z)
    return y, {
        **usual_shifts_and_drifts(y, x, t, 1),
        **of_drivers(y, x, power=z),
        "power, bent twice": line(y, x, v, v**2, v**3),
        **drivers_and_drift(y, x, t, power=z),
    }
