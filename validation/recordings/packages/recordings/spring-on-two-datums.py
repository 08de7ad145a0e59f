"""Flow of a spring run over its stage, each third day of 1967 to 1972 and of 2003 to 2022. Its gauge was set up again in between, with its zero 12 m higher."""

from durations import DAY
from models.fitting import line
from models.jumps import switched_at
from models.lags import usual
from readers.hydrotoolbox import spring

HAND_BUILT = "step, and drift after it"
GAP, AGAIN = 9e8, 1.6e9


def rows(content):
    return spring(content, "stage_m", "flow_m3_s", every=3)


def models(c):
    y, x, t = c["flow_m3_s"], c["stage_m"], c["time_s"]
    return y, {
        **usual(y, x, t, 20 * DAY),
        **switched_at(y, x, t, GAP),
        "two steps": line(y, x, t > GAP, t > AGAIN),
        "two steps, and drift": line(y, x, t > GAP, t > AGAIN, t),
        "two steps, and drift after the first": line(y, x, t > GAP, t > AGAIN, (t > GAP) * t),
    }
