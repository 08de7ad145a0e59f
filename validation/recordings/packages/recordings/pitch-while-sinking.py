"""Pitch of a glider over pressure, on its ways down below 10 m, 3000 rows of fourteen dives. Next to nothing is missing."""

from models.bends import usual_and_bends
from readers.gliderflight import sinking_glider

HAND_BUILT = "fifth power"


def rows(content):
    frame = sinking_glider(content)
    frame = frame[(frame.pumped_cm3 < -200) & (frame.pressure_bar > 1)].iloc[:3000]
    return {"time_s": frame.time_s, "pressure_bar": frame.pressure_bar, "pitch_rad": frame.pitch_rad}


def models(c):
    return c["pitch_rad"], usual_and_bends(c["pitch_rad"], c["pressure_bar"], c["time_s"], 10)
