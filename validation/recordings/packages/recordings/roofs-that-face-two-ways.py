"""What solar cells on one roof give over what those on another do, in the hours of sixty days. One has the sun in the morning, the other in the afternoon."""

from durations import DAY
from models.cycles import tone, usual_and_day
from models.fitting import line, scaled
from readers.citylearn import roofs

HAND_BUILT = "slope by the day"


def rows(*contents):
    return roofs(*contents, begin=0, end=60, least=20)


def models(c):
    y, x, t = c["second_w_kw"], c["first_w_kw"], c["time_s"]
    u, one, two = scaled(x), tone(t, DAY), [*tone(t, DAY), *tone(t, DAY / 2)]
    return y, {
        **usual_and_day(y, x, t),
        "cube": line(y, x, u**2, u**3),
        "one wave a day": line(y, x, *one),
        "three waves a day": line(y, x, *two, *tone(t, DAY / 3)),
        "slope by the day": line(y, x, *two, *(u * part for part in two)),
        "slope by the day alone": line(y, x, *(u * part for part in two)),
        "slope that drifts": line(y, x, u * scaled(t)),
    }
