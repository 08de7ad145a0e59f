"""Thermometer of an oxygen sensor on a glider, against the one of its CTD: it comes quickly for the most part, and slowly for a small one."""

from formats.netcdf import netcdf
from models.fitting import line, terms
from models.lags import lag

HAND_BUILT = "two lags"


def rows(content):
    names = {"time_s": "eng_elaps_t", "ctd_temperature": "temperature", "depth_pressure": "pressure", "optode_temperature": "eng_aa4330_Temp"}
    d = netcdf(content, names).dropna()
    d["time_s"] = (d.time_s - d.time_s.iloc[0]).round(3)
    return d[d.time_s.diff().fillna(1) > 0]


def models(c):
    y, x, t = c["optode_temperature"], c["ctd_temperature"], c["time_s"]

    def lags(p):
        return [lag(x, t, abs(tau)) for tau in p]

    return y, {"line": line(y, x), "one lag": terms(y, lags, [20.0]), HAND_BUILT: terms(y, lags, [10.0, 80.0])}
