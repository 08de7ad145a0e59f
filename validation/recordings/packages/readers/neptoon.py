"""Reads files of the package neptoon."""

import pandas as pd
from formats.clock import seconds
from formats.packed import all_in_zip
from formats.text import csv


def neutron_station(content):
    """Forty days of a neutron probe that writes a file an event, from a zip archive: its numbers by name, in the order of time, and seconds since the first row."""
    names = "number when P1 P3 P4 T1 T2 T3 T4 TCS RH1 RH2 RHCS Vb N1 N2 e1 e2 N1T N1RH N2T N2RH D1".split()
    lines = [line.split(",")[: len(names)] for event in all_in_zip(content).values() for line in event.decode("latin1").splitlines() if line[:1].isdigit()]
    frame = pd.DataFrame([line for line in lines if len(line) == len(names)], columns=names)
    when = pd.to_datetime(frame.pop("when").str.strip(), format="%Y/%m/%d %H:%M:%S", errors="coerce")
    frame = frame.apply(pd.to_numeric, errors="coerce").assign(when=when).dropna().drop_duplicates("number").sort_values("when")
    frame = frame[(frame.when >= "2017-03-01") & (frame.when < "2017-04-10")]
    return frame.assign(time_s=seconds(frame.when))


def soil_logger(content):
    """The first 3000 rows of a soil logger that writes a file an event, from a zip archive: seconds since the first row, and numbers by the place of their column."""
    lines = [line.split() for name, event in all_in_zip(content).items() if name.endswith("TXT") for line in event.decode("latin1").splitlines()]
    frame = pd.DataFrame([line for line in lines if len(line) == 24]).drop(columns=[7, 22, 23]).apply(pd.to_numeric, errors="coerce")
    frame = frame.dropna().drop_duplicates(1).sort_values(1).iloc[:3000]
    return frame[1] - frame[1].iloc[0], frame


def muon_counter(content):
    """Full hours of a counter of neutrons and muons, with seconds since the first; before it was carried to a higher place, on the 111th day."""
    frame = csv(content)
    frame.columns = ["when", "neutrons", "muons", "gamma", "lasted", "supply", "inside", "outside", "humidity", "pressure"]
    frame = frame.drop(columns="gamma").dropna().drop_duplicates("when")
    frame = frame[frame.lasted.between(3590, 3630) & (frame.muons < 12000)]
    frame = frame.assign(time_s=seconds(pd.to_datetime(frame.when)))
    return frame[frame.time_s < 110 * 86400]


def weather_pair(content):
    """The first 3000 hours in which both thermometers and both hygrometers of a site have numbers."""
    frame = csv(content)
    names = ["AirTemperature", "AirTemperature_Sensor2", "AirHumidity_Relative", "AirHumidity_Relative_Sensor2"]
    frame = frame.dropna(subset=names).iloc[:3000]
    return frame.assign(time_s=seconds(pd.to_datetime(frame.DateTime_utc)))
