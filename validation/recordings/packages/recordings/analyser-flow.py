"""Air that the pump of a gas analyser moves, beside the temperature of the air and the pressure in its cell, half hours of the second fortnight of July in which it ran."""

from models.fitting import line
from readers.diive import tower

HAND_BUILT = "temperature"
SECOND_WINDOW = 864000  # s


def rows(content):
    frame = tower(content, "TA_1_1_1", "CUSTOM_AIR_P_MEAN", "CUSTOM_FLOWRATE_MEAN")
    frame = frame[frame.time_s > SECOND_WINDOW]
    return {"time_s": frame.time_s - frame.time_s.iloc[0], "air_c": frame.TA_1_1_1, "cell_pressure_kpa": frame.CUSTOM_AIR_P_MEAN / 1000, "flow_l_min": frame.CUSTOM_FLOWRATE_MEAN * 60000}


def models(c):
    y, x, p, t = c["flow_l_min"], c["air_c"], c["cell_pressure_kpa"], c["time_s"]
    return y, {
        "constant": line(y),
        "drift": line(y, t),
        "pressure": line(y, p),
        HAND_BUILT: line(y, x),
        "temperature, bent": line(y, x, x**2),
        "temperature, and drift": line(y, x, t),
        "temperature, and pressure": line(y, x, p),
    }
