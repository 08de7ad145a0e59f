"""Temperature of a resistor that a thermostat holds at 122 degC over that of its box in a desert, a row each five minutes, three days. It is held until the box is so warm that its cooler is at its end."""

from readers.edges_io import field_receiver, thermostat_models

HAND_BUILT = "knee"


def rows(content):
    frame = field_receiver(content)
    return {"time_s": frame.time_s, "box_c": frame.box_c, "hot_c": frame.hot_c}


def models(c):
    return c["hot_c"], thermostat_models(c["hot_c"], c["box_c"], c["time_s"])
