"""Second axis of a goniometer on an arm over its first, while the arm is bent and stretched, means of a fiftieth of a second. The second follows by a bent law, and a little apart in time."""

from formats.rows import means
from models.bends import usual_and_bends
from readers.biosignalsnotebooks import hubs, seconds_at

HAND_BUILT = "fifth power that is shifted"


def rows(content):
    first, second = (means(values, 20) for values in hubs(content).values())
    return {"time_s": seconds_at(first, 50), "first_count": first, "second_count": second}


def models(c):
    return c["second_count"], usual_and_bends(c["second_count"], c["first_count"], c["time_s"], 0.1)
