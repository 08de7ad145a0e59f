"""One wind meter over another on one stand, a town, seven weeks of summer, each 20 min. They agree."""

from models.lags import usual
from readers.pypromice import tried_in_town

HAND_BUILT = "line"


def rows(content):
    frame = tried_in_town(content, "WindSpeed_S_L", "WindSpeed_S_U")
    return {"time_s": frame.time_s, "lower_m_s": frame.WindSpeed_S_L, "upper_m_s": frame.WindSpeed_S_U}


def models(c):
    return c["upper_m_s"], usual(c["upper_m_s"], c["lower_m_s"], c["time_s"], 600)
