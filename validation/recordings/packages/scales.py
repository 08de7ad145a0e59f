"""Formats of the twenty-fifth set, from bytes to columns (the others are in reading.py, instruments.py, rigs.py, loggers.py, stations.py, housekeeping.py, benches.py, receivers.py, recorders.py, probes.py, sensors.py, monitors.py, meters.py, dials.py, gauges.py, counters.py and pickups.py)."""

import io
import re

import numpy as np
import pandas as pd
from counters import DAY, in_step
from fitting import line, tone
from reading import csv, seconds
from rigs import since
from scipy.io import loadmat

# metres of a degree of latitude; and the ellipsoid of satellites: its radius in m, and the square of its eccentricity
DEGREE, RADIUS, OVAL = 111194, 6378137, 6.69437999014e-3
POINT = re.compile(r'<trkpt lat="([^"]+)" lon="([^"]+)">\s*<ele>[^<]*</ele>\s*<time>([^<]*)</time>')


def sunny_station(content, lowest=None, **names):
    """Minutes of a station, those in which the sun is higher than so many degrees where that is told, columns by the names that they are to have; seconds since the first."""
    frame = csv(content, sep="\t", parse_dates=[0])
    frame = frame if lowest is None else frame[frame["Elev.Sol"] > lowest]
    return {"time_s": seconds(frame.iloc[:, 0]), **{name: frame[column] for name, column in names.items()}}


def module(content, begin, end, least):
    """A module on a roof between two days while the sun sends it at least so much: how warm the air and its back are, and the wind; seconds since the first."""
    frame = csv(content, encoding="latin1", skipinitialspace=True)
    when, sun = pd.to_datetime(frame["Date Time"], format="%d-%b-%Y %H:%M:%S"), frame["DNI (W/m2)"]
    kept = (when >= begin) & (when < end) & (sun > least)
    air, wind, back = (frame.columns[frame.columns.str.startswith(name)][0] for name in ("T_Amb", "Wind Speed", "T_Backplane"))
    return {"time_s": seconds(when[kept]), "air_degc": frame[air][kept], "wind_m_s": frame[wind][kept], "back_degc": frame[back][kept]}


def watch(content):
    """Seconds, latitude and longitude in degrees of the points of a watch (GPX)."""
    found = POINT.findall(content.decode())
    north, east = np.array([point[:2] for point in found], float).T
    return clock([point[2] for point in found]), north, east


def receiver(content):
    """The same of a receiver that tells places from the middle of the Earth (RTKLIB)."""
    lines = [line.split() for line in content.decode().splitlines() if line[:1] != "%"]
    x, y, z = np.array([line[2:5] for line in lines], float).T
    out = np.hypot(x, y)
    north = np.arctan2(z, out * (1 - OVAL))
    for _ in range(5):
        bent = RADIUS / np.sqrt(1 - OVAL * np.sin(north) ** 2)
        north = np.arctan2(z + OVAL * bent * np.sin(north), out)
    return clock([f"{line[0]} {line[1]}" for line in lines]), np.degrees(north), np.degrees(np.arctan2(y, x))


def clock(texts):
    """Seconds since 2021-07-01 of times as they are told, all as if at one place."""
    return (pd.to_datetime(pd.Series(texts), utc=True, format="mixed") - pd.Timestamp("2021-07-01", tz="UTC")).dt.total_seconds().to_numpy()


def together(first, second, way, every, late=0):
    """Each so many points of a second track while the first lasts: seconds since the first of them, and how far north or east both are in m. The first is straight between its points, and its clock is put forward by `late` seconds."""
    then, now = first[0] + late, second[0]
    kept = (now >= then[0] + 5) & (now <= then[-1] - 5)
    wide = DEGREE * (np.cos(np.radians(second[1].mean())) if way == "east" else 1)
    at = {"north": 1, "east": 2}[way]
    there, here = np.interp(now[kept], then, first[at]), second[at][kept]
    told = {"time_s": since(now[kept]), "first_m": (there - there.mean()) * wide, "second_m": (here - there.mean()) * wide}
    return {name: np.round(values[::every], 3) for name, values in told.items()}


def passers_by(content, begin, end, **names):
    """People that two counters saw in each hour between two days; seconds since the first."""
    frame = csv(content)
    when = pd.to_datetime(frame.date) + pd.to_timedelta(frame.hour.str.split(":").str[0].astype(int), unit="h")
    kept = frame.assign(when=when)[(when >= begin) & (when < end)].dropna(subset=list(names.values())).sort_values("when")
    return {"time_s": seconds(kept.when), **{name: kept[column] for name, column in names.items()}}


def by_the_hour(here, there, t):
    """Models of what one counter sees by what the other does: hours of a day and of a week may be others for the two."""
    one, waves, week = tone(t, DAY), [part for k in (1, 2, 3) for part in tone(t, DAY / k)], tone(t, 7 * DAY)
    return {
        **in_step(here, there, t),
        "one wave a day": line(here, there, *one),
        "three waves a day": line(here, there, *waves),
        "three waves a day, and square": line(here, there, there**2, *waves),
        "square, and cube": line(here, there, there**2, there**3),
        "waves that go with days and weeks": line(here, there, *waves, *week),
        "slope by the day": line(here, there, *waves, *(there * part for part in one)),
    }


def bottles(*contents, **names):
    """What a probe told where bottles were closed in the sea, one cast after the other, by the places of the columns behind the time."""
    found = []
    for cast, content in enumerate(contents, 1):
        closed = [line.split() for line in content.decode("latin1").splitlines() if line.endswith("(avg)")]
        found += [[cast, *(float(line[4 + place]) for place in names.values())] for line in closed]
    return dict(zip(["run", *names], np.array(found).T))


def paces(told):
    """Where strides begin and end in s, and how long they are in m, of one way to see them."""
    bouts = [bout for bout in np.atleast_1d(told.MicroWB) if np.size(bout.Stride_Length)]
    rows = np.vstack([np.column_stack([np.atleast_2d(bout.Stride_InitialContacts), np.atleast_1d(bout.Stride_Length)]) for bout in bouts] or [np.empty((0, 3))])
    rows = rows[np.isfinite(rows).all(axis=1)]
    counted = len(rows) and np.median(rows[:, 1] - rows[:, 0]) > 20
    return rows / [100, 100, 1] if counted else rows


def strides(*contents, apart):
    """Lengths of strides by cameras and by what was worn, where both begin and end them within so many seconds."""
    found = []
    for content in contents:
        data = loadmat(io.BytesIO(content), squeeze_me=True, struct_as_record=False)["data"]
        for walk in walks(data):
            seen, worn = paces(walk.Standards.Stereophoto), paces(walk.Standards.INDIP)
            for stride in worn if len(seen) else []:
                off = np.abs(seen[:, :2] - stride[:2]).max(axis=1)
                if off.min() < apart:
                    found.append([seen[off.argmin(), 2], stride[2]])
    return dict(zip(("cameras_m", "worn_m"), np.array(found).T))


def walks(data):
    """Trials of a person that both cameras and worn sensors saw."""
    tests = [getattr(time, test) for time in parts(data) for test in time._fieldnames]
    for trial in (trial for test in tests for trial in parts(test)):
        standards = getattr(trial, "Standards", None)
        if hasattr(standards, "Stereophoto") and hasattr(standards, "INDIP"):
            yield trial


def parts(struct):
    """What a struct of MATLAB holds, without the names."""
    return [getattr(struct, name) for name in struct._fieldnames]


def tissue(content, kind, **wavenumbers):
    """How much infrared light one kind of tissue takes away near some wavenumbers, a spectrum a row."""
    frame = csv(content, skiprows=[1, 2])
    frame = frame[frame.type == kind]
    told = frame.columns[1:].astype(float)
    return {name: frame.iloc[:, 1 + np.argmin(np.abs(told - one))] for name, one in wavenumbers.items()}


def wet_soil(probe, satellite, minutes):
    """How wet soil is by a satellite and by a good reading of a probe so near to it in time; seconds since the first."""
    told = csv(probe, parse_dates=["date_time"]).rename(columns={"date_time": "when"})
    seen = csv(satellite, parse_dates=[0])
    seen = seen.rename(columns={seen.columns[0]: "when"}).dropna(subset=["sm"])
    both = pd.merge_asof(seen, told[told.soil_moisture_flag == "G"], on="when", direction="nearest", tolerance=pd.Timedelta(minutes=minutes))
    both = both.dropna(subset=["soil_moisture"])
    return {"time_s": seconds(both.when), "satellite_percent": both.sm, "probe_m3_m3": both.soil_moisture}


def farm_days(*contents):
    """Days of a station on a farm: the coldest and the warmest in degC, the sun in MJ/m2, and the pressure of vapour; seconds since the first."""
    cells = [line.split() for content in contents for line in content.decode("latin1").splitlines() if line[:1] != "*"]
    rows = np.array([line for line in cells if len(line) == 9], float)
    when = pd.to_datetime(pd.Series(rows[:, 1].astype(int) * 1000 + rows[:, 2].astype(int)).astype(str), format="%Y%j")
    return {"time_s": seconds(when), "coldest_degc": rows[:, 4], "sun_mj_m2": rows[:, 3] / 1000, "vapour_kpa": rows[:, 6], "warmest_degc": rows[:, 5]}
