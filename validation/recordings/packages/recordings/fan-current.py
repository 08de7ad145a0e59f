"""Current of the fan that draws air past the thermometers of a station on a glacier, over the voltage of its battery, beside the wind, one August, each 10 min."""

from models.fitting import line
from models.lags import usual
from readers.pypromice import logger_table

HAND_BUILT = "wind, bent"


def rows(content):
    frame = logger_table(content, "VoltageBatteries", "WindSpeed", "FanCurrent_Avg")
    return {"time_s": frame.time_s, "supply_v": frame.VoltageBatteries, "wind_m_s": frame.WindSpeed, "fan_ma": frame.FanCurrent_Avg}


def models(c):
    y, x, t, wind = c["fan_ma"], c["supply_v"], c["time_s"], c["wind_m_s"]
    return y, {
        **usual(y, x, t, 600),
        "wind": line(y, x, wind),
        HAND_BUILT: line(y, x, wind, wind**2),
        "gain by wind": line(y, x, x * wind),
        "wind, bent, and square": line(y, x, x**2, wind, wind**2),
    }
