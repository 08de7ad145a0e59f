"""People that a counter sees in an hour over those that one across the street sees, 39 days of winter."""

from counters import DAY, in_step
from fitting import line, tone
from scales import passers_by

HAND_BUILT = "slope by the day"


def rows(content):
    return passers_by(content, "2019-06-01", "2019-07-10", across="205 Queen Street", here="210 Queen Street")


def models(c):
    y, x, t = c["here"], c["across"], c["time_s"]
    one, waves, week = tone(t, DAY), [part for k in (1, 2, 3) for part in tone(t, DAY / k)], tone(t, 7 * DAY)
    return y, {
        **in_step(y, x, t),
        "one wave a day": line(y, x, *one),
        "three waves a day": line(y, x, *waves),
        "three waves a day, and square": line(y, x, x**2, *waves),
        "square, and cube": line(y, x, x**2, x**3),
        "waves that go with days and weeks": line(y, x, *waves, *week),
        "slope by the day": line(y, x, *waves, *(x * part for part in one)),
    }
