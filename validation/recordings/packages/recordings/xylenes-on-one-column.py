"""Two kinds of xylene in the air of a town, which come from the same wheels and leave one column as two peaks. Next to nothing is missing."""

from fitting import line
from monitors import air_station
from recorders import usual_and_bends

HAND_BUILT = "slope that drifts"


def rows(content):
    read = air_station(content, "m/p-Xylene", "o-Xylene")
    return {"time_s": read.time_s, "first_ppb": read["m/p-Xylene"], "second_ppb": read["o-Xylene"]}


def models(c):
    y, x, t = c["second_ppb"], c["first_ppb"], c["time_s"]
    return y, {**usual_and_bends(y, x, t, 3600), "square, and drift": line(y, x, x**2, t), "slope that drifts": line(y, x, t, x * t)}
