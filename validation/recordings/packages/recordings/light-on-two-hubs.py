"""Light by a sensor on one hub over that by a sensor on another, which a cable keeps in step, while a lamp is switched, means of a fiftieth of a second. One of them is bent."""

from formats.rows import means
from models.bends import usual_and_bends
from readers.biosignalsnotebooks import hubs, seconds_at

HAND_BUILT = "cube"


def rows(content):
    first, second = (means(values, 20) for values in hubs(content).values())
    return {"time_s": seconds_at(first, 50), "first_count": first, "second_count": second}


def models(c):
    return c["second_count"], usual_and_bends(c["second_count"], c["first_count"], c["time_s"], 0.05)
