"""Two cup anemometers on one mast beside a wind turbine, ten minutes. They agree but for gusts, which reach one of them a fifth of a second earlier."""

from models.lags import usual_and_lags
from readers.wetb import turbine_sensors

HAND_BUILT = "shift"


def rows(content):
    read = turbine_sensors(content)
    return {"time_s": read["time_s"], "thies_m_s": read["WspThies"], "backup_m_s": read["WspBup"]}


def models(c):
    return c["backup_m_s"], usual_and_lags(c["backup_m_s"], c["thies_m_s"], c["time_s"], -0.5)
