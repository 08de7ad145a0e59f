"""Formats of the twenty-seventh set, from bytes to columns (the others are in reading.py, instruments.py, rigs.py, loggers.py, stations.py, housekeeping.py, benches.py, receivers.py, recorders.py, probes.py, sensors.py, monitors.py, meters.py, dials.py, gauges.py, counters.py, pickups.py, scales.py and levels.py)."""

import numpy as np
import pandas as pd
from fitting import lag, line, moved, scaled, terms, tone
from gauges import DAY
from levels import behind
from pickups import clocks
from reading import csv, seconds

PLACES, FINER = np.arange(0.05, 0.951, 0.01), np.arange(-0.01, 0.0101, 0.0005)


def flight(content, begin, every, scale=None, **names):
    """Columns of a flight from some second on, each so many of the rows that have numbers in all of them; seconds since the first, and columns by the names that they are to have."""
    frame = csv(content)
    frame = frame[frame.ts > begin].dropna(subset=list(names.values())).iloc[::every]
    time = frame.ts.to_numpy() - frame.ts.iloc[0]
    return {"time_s": time, **{name: frame[column].to_numpy() * (scale or {}).get(name, 1) for name, column in names.items()}}


def engines(content):
    """Jet engines with their flow of fuel when they take off, in the order of the list: bypass ratio, thrust in kN, fuel in kg/s. Those that mix their streams are left out."""
    frame = csv(content)
    frame = frame[frame.type == "TF"].dropna(subset=["bpr", "max_thrust", "ff_to"])
    return {"bypass": frame.bpr, "thrust_kn": frame.max_thrust / 1000, "fuel_kg_s": frame.ff_to}


def exercise(content, every, **names):
    """Columns of an exercise test by the names that they are to have, each so many seconds: between breaths the table is straight."""
    frame = csv(content).iloc[::every]
    return {"time_s": frame.time - frame.time.iloc[0], **{name: frame[column] for name, column in names.items()}}


def storm(rows, events, number):
    """Flow and turbidity of a river during one event of a list, where both have numbers; seconds since the first row."""
    frame, told = csv(rows).dropna(), csv(events).iloc[number]
    at = pd.to_datetime(frame.datetime, utc=True)
    kept = (at >= pd.to_datetime(told.start, utc=True)) & (at <= pd.to_datetime(told.end, utc=True))
    return {"time_s": seconds(at[kept]), "flow_m3_s": frame.Qcms[kept], "turbidity_fnu": frame.turb[kept]}


def surveyed(content):
    """Rows of a survey from the air as a data frame, in their order."""
    cells = [text.split() for text in content.decode("latin1").splitlines()]
    head = next(line for line in cells if "FTIME" in line)[1:]
    frame = pd.DataFrame([line for line in cells if len(line) == len(head) and line[0][0].isdigit()], columns=head)
    return frame.apply(pd.to_numeric, errors="coerce")


def survey(content, **names):
    """Columns of a survey by the names that they are to have; a line that was flown is a run. Seconds are those of the day's clock since the first row."""
    frame = surveyed(content)
    return {"run": pd.factorize(frame.LINE)[0] + 1, "time_s": frame.FTIME - frame.FTIME.iloc[0], **{name: frame[column] for name, column in names.items()}}


def flown_again(content, every, what):
    """What was told along a line as it was flown again and again, each so many rows from west to east, beside what was told the first time at the same places; a flight is a run."""
    frame = surveyed(content)
    first, *others = (rows.sort_values("MGA-X") for _, rows in frame.groupby("LINE"))
    found = []
    for run, rows in enumerate(others, 1):
        rows = rows[rows["MGA-X"].between(first["MGA-X"].iloc[0], first["MGA-X"].iloc[-1])].iloc[::every].dropna(subset=[what])
        found.append(np.column_stack([np.full(len(rows), run), np.interp(rows["MGA-X"], first["MGA-X"], first[what]), rows[what]]))
    run, before, again = np.concatenate(found).T
    return {"run": run.astype(int), "first_mgal": np.round(before, 6), "again_mgal": again}


def over_rows(x, run, rows):
    """Means over so many rows about each, inside of its run."""
    return np.concatenate([pd.Series(x[run == one]).rolling(rows, center=True, min_periods=1).mean() for one in np.unique(run)])


def charts(first, second):
    """Reflectance of the same patches of two charts at the wavelengths that both have; a patch is a run."""
    one, other = (csv(content).set_index("wavelength") for content in (first, second))
    both = one.index.intersection(other.index)
    patches = len(one.columns)
    seen = [table.loc[both].to_numpy().T.ravel() for table in (one, other)]
    return {"run": np.repeat(np.arange(patches) + 1, len(both)), "nm": np.tile(both.to_numpy(), patches), "first": seen[0], "second": seen[1]}


def plant(content, **names):
    """Columns of a plant by the names that they are to have; seconds since the first row."""
    frame = csv(content)
    columns = {name: pd.to_numeric(frame[column], errors="coerce") for name, column in names.items()}
    return {"time_s": seconds(pd.to_datetime(frame.iloc[:, 0])), **columns}


def changed(y, t, beside, what):
    """A model whose zero, or a slope, is another from some time on: `what` gives the term `beside` the others, and the time is that at which the rows seen are fitted best."""
    model = lambda place: line(y, *beside, what * (t > t[0] + place * (t[-1] - t[0])))

    def predicted(seen):
        left = lambda place: np.std((y - model(place)(seen))[seen])
        about = min(PLACES, key=left)
        return model(min(about + FINER, key=left))(seen)

    return predicted


def days(y, x, t):
    """Models of what goes with the time of day beside a bend, a drift and a zero or a slope that changes at some time."""
    u, w, day, one = scaled(x), scaled(t), [*tone(t, DAY), *tone(t, DAY / 2)], np.ones(len(y))
    return {
        "one wave a day": line(y, x, *tone(t, DAY)),
        "day": line(y, x, *day),
        "three waves a day": line(y, x, *day, *tone(t, DAY / 3)),
        "step": changed(y, t, [x], one),
        "day, and square": line(y, x, u**2, *day),
        "day, and cube": line(y, x, u**2, u**3, *day),
        "day, and drift": line(y, x, w, *day),
        "day, drift, and its square": line(y, x, w, w**2, *day),
        "day, and slope that drifts": line(y, x, w, u * w, *day),
        "day, and slope by it": line(y, x, *day, *(u * part for part in day)),
        "day, and step": changed(y, t, [x, *day], one),
        "day, and slope that changes": changed(y, t, [x, *day], u),
        "day alone": line(y, *day),
    }


def instruments(c):
    """Two instruments of a plant, and models of one over the other."""
    y, x, t = c["second"], c["first"], c["time_s"]
    u, w = scaled(x), scaled(t)
    return y, {
        **clocks(y, x, t, 300),
        "cube": line(y, x, u**2, u**3),
        "drift, and its square": line(y, x, w, w**2),
        "line, and lag": terms(y, lambda p: [x, lag(x, t, abs(p[0]) * 1800)], [2.0]),
        **days(y, x, t),
    }


def hearts(c):
    """Heart beats over oxygen, and their models: what comes late, what bends, and what drifts."""
    y, x, t = c["heart_per_min"], c["oxygen_ml_min"], c["time_s"]
    u, w, late = scaled(x), scaled(t), lambda p: lag(x, t, abs(p) * 20)
    bend = lambda p: (late(p[0]), scaled(late(p[0])) ** 2, scaled(late(p[0])) ** 3)
    return y, {
        **clocks(y, x, t, 20),
        "cube": line(y, x, u**2, u**3),
        "drift, and its square": line(y, x, w, w**2),
        "drift, and slope that drifts": line(y, x, w, u * w),
        "square, and drift": line(y, x, u**2, w),
        "cube, and drift": line(y, x, u**2, u**3, w),
        "logarithm": line(y, x, np.log(t + 10)),
        "lag, and square": terms(y, lambda p: bend(p)[:2], [1.0]),
        "lag, and cube": terms(y, bend, [1.0]),
        "lag, and drift": terms(y, lambda p: [late(p[0]), w], [1.0]),
        "lag, cube, and drift": terms(y, lambda p: [*bend(p), w], [1.0]),
        "line, and lag": terms(y, lambda p: [x, late(p[0])], [1.0]),
        "two lags": terms(y, lambda p: [late(p[0]), late(p[1])], [1.0, 4.0]),
        "lag of a lag": terms(y, lambda p: [lag(late(p[0]), t, abs(p[1]) * 20)], [1.0, 0.5]),
        "lag, and shift": terms(y, lambda p: [moved(late(p[0]), t, p[1] * 20)], [1.0, 0.5]),
        "drift alone": line(y, w),
    }


def mud(c):
    """Turbidity over flow, and their models: what comes early or late, what is washed out, what bends, and what drifts."""
    y, x, t = c["turbidity_fnu"], c["flow_m3_s"], c["time_s"]
    u, w, hour = scaled(x), scaled(t), 3600
    return y, {
        **clocks(y, x, t, 4 * hour),
        "cube": line(y, x, u**2, u**3),
        "drift, and slope that drifts": line(y, x, w, u * w),
        "square, and drift": line(y, x, u**2, w),
        "square, drift, and slope that drifts": line(y, x, u**2, w, u * w),
        **behind(y, x, t, 3 * hour),
        "line, lag, and square": terms(y, lambda p: [x, u**2, lag(x, t, abs(p[0]) * 3 * hour)], [1.0]),
        "line, lag, and drift": terms(y, lambda p: [x, w, lag(x, t, abs(p[0]) * 3 * hour)], [1.0]),
        "line, lag, and slope that drifts": terms(y, lambda p: [x, w, u * w, lag(x, t, abs(p[0]) * 3 * hour)], [1.0]),
        "line, lag, and shift": terms(y, lambda p: [moved(x, t, p[1] * hour), lag(moved(x, t, p[1] * hour), t, abs(p[0]) * 3 * hour)], [1.0, -0.3]),
    }
