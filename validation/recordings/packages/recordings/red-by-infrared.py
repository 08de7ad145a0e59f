"""Red light through skin over infrared light through it, a minute, means of a twentieth of a second. The law is bent, and what is quick has another slope than what is slow."""

from formats.rows import means
from models.bends import usual_and_bends
from readers.biosignalsnotebooks import hubs, seconds_at

HAND_BUILT = "fifth power, and lag"


def rows(content):
    infrared, red = (means(values, 50)[4:] for values in hubs(content).values())
    return {"time_s": seconds_at(red, 20), "infrared_count": infrared, "red_count": red}


def models(c):
    return c["red_count"], usual_and_bends(c["red_count"], c["infrared_count"], c["time_s"], 1.0)
