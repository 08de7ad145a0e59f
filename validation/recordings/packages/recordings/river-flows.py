"""Flow of a river over that at a gauge upstream, 3500 days from 2001 on, means of a day. Water needs half a day to come down."""

from readers.tstoolbox import river_gauges, river_models

HAND_BUILT = "shift"


def rows(first, second):
    at, above, below = river_gauges(first, second, 0)
    return {"time_s": at, "above_ft3_s": above, "below_ft3_s": below}


def models(c):
    return c["below_ft3_s"], river_models(c["below_ft3_s"], c["above_ft3_s"], c["time_s"])
