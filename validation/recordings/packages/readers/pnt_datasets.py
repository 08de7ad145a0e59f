"""Reads files of the package pnt-datasets: when radio of stations under the ceiling of a hall comes in, and how strong it is.

An arrival is told in m, as ns times the speed of light. Rows in which a station is missing are left out.
"""

import io

import numpy as np
import pandas as pd
from formats.clock import since_first
from models.drifts import usual_shifts_and_drifts
from models.drivers import of_drivers, two_drivers

METRE_PER_NS = 0.299792458
RECEIVER_M = 1.2  # no height of the receiver is told
TIME, STATION, ARRIVAL, POWER = "timestamp (s)", "Node ID", "TOA (ns)", "Rsrp (dBm)"


def table(content):
    """A table of a session."""
    return pd.read_parquet(io.BytesIO(content))


def by_station(content):
    """Arrivals in m and powers in dBm, rows by time, columns by station."""
    frame = table(content)
    arrivals, powers = (frame.pivot(index=TIME, columns=STATION, values=name) for name in (ARRIVAL, POWER))
    return arrivals * METRE_PER_NS, powers


def by_time(frame):
    """Columns of a table by time, of rows in which none is missing; seconds since the first of these."""
    frame = frame.dropna()
    return {"time_s": since_first(frame.index).round(3), **{name: frame[name].to_numpy() for name in frame}}


def pair(content, first, second):
    """Two stations: arrivals at them in m and their powers in dBm; seconds since the first row."""
    arrivals, powers = by_station(content)
    columns = {"first_m": arrivals[first], "second_m": arrivals[second], "first_dbm": powers[first], "second_dbm": powers[second]}
    return by_time(pd.DataFrame(columns))


def distances(places, stations):
    """Distances in m from places, a row each with x and y in m, to the stations, a column each."""
    found = {}
    for at in table(stations).to_dict("records"):
        found[at[STATION]] = np.sqrt((places["X (m)"] - at["X (m)"]) ** 2 + (places["Y (m)"] - at["Y (m)"]) ** 2 + (at["Z (m)"] - RECEIVER_M) ** 2)
    return pd.DataFrame(found)


def at_places(measured, places, stations):
    """Where the place of the receiver is told: arrivals and powers as `by_station`, and distances in m to the stations in the same form."""
    arrivals, powers = by_station(measured)
    known = table(places).set_index(TIME).sort_index()
    known = known[known.index.isin(arrivals.index)]
    return arrivals.loc[known.index], powers.loc[known.index], distances(known, stations)


def clock(measured, places, stations):
    """How much later radio comes in than distances say, m, mean over all stations, between the first told place and the last; places are straight between. Seconds since the first row."""
    arrivals, _ = by_station(measured)
    known = table(places).set_index(TIME).sort_index()
    arrivals = arrivals.loc[known.index[0] : known.index[-1]].dropna()
    at = pd.DataFrame({axis: np.interp(arrivals.index, known.index, known[axis]) for axis in ("X (m)", "Y (m)")}, arrivals.index)
    return by_time((arrivals - distances(at, stations)).mean(axis=1).to_frame("late_m"))


def pair_models(c):
    """Models of one arrival over another beside both powers and the clock; rows are 0.08 or 0.2 s apart, or more."""
    y, x, t = c["second_m"], c["first_m"], c["time_s"]
    powers = {"first power": c["first_dbm"], "second power": c["second_dbm"]}
    return y, {**usual_shifts_and_drifts(y, x, t, 1), **of_drivers(y, x, **powers), **two_drivers(y, x, **powers)}
