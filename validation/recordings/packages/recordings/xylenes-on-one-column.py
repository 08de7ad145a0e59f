"""Two kinds of xylene in the air of a town, which come from the same wheels and leave one column as two peaks. Next to nothing is missing."""

from models.bends import usual_and_bends
from models.fitting import line
from readers.aeroviz import air_station

HAND_BUILT = "slope that drifts"


def rows(content):
    read = air_station(content, "m/p-Xylene", "o-Xylene")
    return {"time_s": read.time_s, "first_ppb": read["m/p-Xylene"], "second_ppb": read["o-Xylene"]}


def models(c):
    y, x, t = c["second_ppb"], c["first_ppb"], c["time_s"]
    return y, {**usual_and_bends(y, x, t, 3600), "square, and drift": line(y, x, x**2, t), "slope that drifts": line(y, x, t, x * t)}
