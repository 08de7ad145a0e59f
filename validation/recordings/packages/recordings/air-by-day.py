"""Temperature that a barometer has which hangs in the open at a well, 73 days from May to July, each hour. It is warm by day."""

from formats.clock import seconds
from models.cycles import tone
from models.fitting import line
from readers.gensor import diver

HAND_BUILT = "day and half a day"


def rows(content):
    frame = diver(content)
    frame = frame[(frame.when >= "2021-05-20") & (frame.when < "2021-08-01")]
    return {"time_s": seconds(frame.when), "air_c": frame.degc}


def models(c):
    y, t = c["air_c"], c["time_s"]
    return y, {
        "constant": line(y),
        "drift": line(y, t),
        "day": line(y, *tone(t, 86400)),
        HAND_BUILT: line(y, *tone(t, 86400), *tone(t, 43200)),
        "day, and drift": line(y, *tone(t, 86400), t),
    }
