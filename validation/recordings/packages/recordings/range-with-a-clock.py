"""How far a receiver is from a station as radio tells, over how far it was, beside the clock of the receiver as seven other stations tell it. 384 places of a hall in 27 minutes."""

import pandas as pd
from models.drifts import usual_shifts_and_drifts
from models.drivers import of_drivers
from models.fitting import line, scaled
from readers.pnt_datasets import at_places, by_time

HAND_BUILT = "clock"
STATION = 6


def rows(measured, places, stations):
    arrivals, _, distances = at_places(measured, places, stations)
    clock = (arrivals - distances).drop(columns=STATION).mean(axis=1)
    return by_time(pd.DataFrame({"distance_m": distances[STATION], "clock_m": clock, "arrival_m": arrivals[STATION]}))


def models(c):
    y, x, t, z = c["arrival_m"], c["distance_m"], c["time_s"], c["clock_m"]
    u, v, w = scaled(x), scaled(z), scaled(t)
    return y, {
        **usual_shifts_and_drifts(y, x, t, 1),
        **of_drivers(y, x, clock=z),
        "clock, and drift": line(y, x, v, w),
        "clock, square, and drift": line(y, x, u**2, v, w),
        "clock, and slope that drifts": line(y, x, v, w, u * w),
    }
