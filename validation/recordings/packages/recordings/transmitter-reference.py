"""Reference voltage inside of a weather transmitter on a ship, a day, every minute, while its heater goes on and off and pulls the supply from 15 to 11 V: it does not move. Read in steps of 1 mV."""

from formats.netcdf import netcdf
from models.fitting import line

HAND_BUILT = "constant"


def rows(content):
    names = {"air_c": "temperature_ambient", "supply_v": "supply_volts", "reference_mv": "ref_volts"}
    d = netcdf(content, names).dropna()
    return {"time_s": d.index.to_numpy() * 60.0, "air_c": d.air_c, "supply_v": d.supply_v, "reference_mv": d.reference_mv * 1e3}


def models(c):
    y, t = c["reference_mv"], c["time_s"]
    return y, {"constant": line(y), "temperature": line(y, c["air_c"]), "supply": line(y, c["supply_v"]), "drift": line(y, t)}
