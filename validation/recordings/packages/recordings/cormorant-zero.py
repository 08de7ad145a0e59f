"""Depth by a logger on a cormorant while it is calm and out of the water, beside the temperature of the logger, 41 hours, about 3000 rows. The zero follows the temperature, and comes to rest after it."""

from readers.cpforager import out_of_water, zero_models

HAND_BUILT = "temperature, and late temperature"


def rows(content):
    frame = out_of_water(content)
    return {"time_s": frame.time_s, "logger_c": frame.temperature, "depth_m": frame.pressure}


def models(c):
    return c["depth_m"], zero_models(c["depth_m"], c["logger_c"], c["time_s"])
