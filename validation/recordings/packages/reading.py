"""Formats that several recordings share, from bytes to columns."""

import io
import re
import struct
import zipfile

import numpy as np
import pandas as pd


def nist(content, columns):
    """The data of a file of the NIST Statistical Reference Datasets."""
    lines = content.decode().splitlines()
    start = max(k for k, line in enumerate(lines) if line.startswith("Data:")) + 1
    values = np.array([[float(v) for v in line.split()] for line in lines[start:] if line.strip()])
    return dict(zip(columns, values.T))


def csv(content, **options):
    """A CSV as a data frame."""
    return pd.read_csv(io.BytesIO(content), **options)


def seconds(times):
    """Seconds since the first of a column of times."""
    return (times - times.iloc[0]).dt.total_seconds().to_numpy()


def numbers(content):
    """One number a line; lines that begin with # are comments."""
    return np.array([float(line) for line in content.decode().splitlines() if line[:1] != "#"])


def solar_array(content):
    """The columns of the solar array `NREL RSF II` that are used here: 15 min, five winter days."""
    names = {
        "ambient_temp__1053": "ambient",
        "module_temp__1056": "module",
        "poa_irradiance__1055": "poa",
        "poa_irradiance_refcell__1054": "refcell",
        "refcell_temp__1052": "refcell_temp",
        "wind_speed__1051": "wind",
        "inv2_temp__1050": "inverter_temp",
        "inv2_dc_power__1135": "dc_power",
        "inv2_ac_power_w__1047": "ac_power",
    }
    frame = csv(content)
    out = frame.rename(columns=names)[list(names.values())]
    return out.assign(time_s=seconds(pd.to_datetime(frame.iloc[:, 0])))


def cast(content, rows=None):
    """The rows of a lowering of a CTD, by time: those with numbers in all of the first ten columns."""
    with np.load(io.BytesIO(content), allow_pickle=False) as file:
        frame = pd.DataFrame(file["data"].T, columns=list(file["varnames"]))
    frame = frame[(np.abs(frame.iloc[:, :10]) < 1e4).all(axis=1)]
    return frame[frame["timeS"].diff().fillna(1) > 0].iloc[:rows]


def ameriflux(content, begin, end, names):
    """Columns of a half-hourly AmeriFlux file between two days: rows with numbers in all of them, and seconds since the first day."""
    frame = csv(content, skiprows=2, na_values=[-9999], usecols=["TIMESTAMP_START", *names])
    at = pd.to_datetime(frame.TIMESTAMP_START.astype(str), format="%Y%m%d%H%M")
    kept = (at >= begin) & (at < end) & frame[names].notna().all(axis=1)
    return frame[kept].assign(time_s=(at[kept] - pd.Timestamp(begin)).dt.total_seconds())


def netcdf(content, names):
    """Columns of a netCDF file by the names that they are to have; what is masked or not there is nan."""
    import netCDF4  # the other readers do without it

    with netCDF4.Dataset("memory", memory=content) as file:
        return pd.DataFrame({name: np.ma.filled(file[column][:].astype(float), np.nan) for name, column in names.items()})


def means(values, rows):
    """Means of so many values each; a rest at the end is left away."""
    values = np.asarray(values, float)
    return values[: len(values) // rows * rows].reshape(-1, rows).mean(axis=1)


def jpk(content):
    """Segments of a force curve of a JPK microscope, in its order: duration in seconds, and channels by name as volts or metres of the encoder."""
    with zipfile.ZipFile(io.BytesIO(content)) as file:
        shared = properties(file.read("shared-data/header.properties"))
        inside = file.namelist()
        for k in range(sum(name.endswith("/segment-header.properties") for name in inside)):
            header = properties(file.read(f"segments/{k}/segment-header.properties"))
            start = f"segments/{k}/channels/"
            names = [name.removeprefix(start).removesuffix(".dat") for name in inside if name.startswith(start) and name.endswith(".dat")]
            channels = {name: encoded(file.read(f"{start}{name}.dat"), shared, header[f"channel.{name}.lcd-info.*"]) for name in names}
            yield float(header["force-segment-header.duration"]), channels


def properties(content):
    """Lines `key=value` of a Java properties file."""
    return dict(line.split("=", 1) for line in content.decode().splitlines() if "=" in line)


def encoded(content, shared, number):
    """Numbers of a channel: whole ones with gain and offset of the encoder, else floating ones."""
    kind = shared.get(f"lcd-info.{number}.encoder.type", "")
    at = f"lcd-info.{number}.encoder.scaling"
    values = np.frombuffer(content, {"signedshort": ">i2", "signedinteger": ">i4"}.get(kind.removesuffix("-limited"), ">f4")).astype(float)
    return values * float(shared.get(f"{at}.multiplier", 1)) + float(shared.get(f"{at}.offset", 0))


def speed_coach(content):
    """Strokes of a rowing computer: numbers by the names of its columns, and seconds since the start."""
    lines = content.decode("utf-8-sig").splitlines()
    start = next(k for k, text in enumerate(lines) if text.startswith("Per-Stroke Data"))
    header = next(k for k in range(start + 1, len(lines)) if lines[k].startswith("Interval,"))
    frame = pd.read_csv(io.StringIO("\n".join([lines[header], *lines[header + 2 :]])))
    clock = pd.to_timedelta(frame.pop("Elapsed Time"), errors="coerce").dt.total_seconds()
    return frame.apply(pd.to_numeric, errors="coerce").assign(time_s=clock)


def dives(contents, names):
    """Columns of one group of a glider's dives, one under the other, with the number of the dive from 1 on."""
    return pd.concat([netcdf(content, names).assign(dive=number) for number, content in enumerate(contents, 1)], ignore_index=True)


def names_in_zip(content):
    """Names of the files in a zip archive."""
    with zipfile.ZipFile(io.BytesIO(content)) as file:
        return file.namelist()


def in_zip(content, name):
    """Bytes of a file in a zip archive."""
    with zipfile.ZipFile(io.BytesIO(content)) as file:
        return file.read(name)


def link_loss(content, link):
    """Loss of one microwave link in dB, means of 5 min, one row for each of its two channels; what was not measured is nan."""
    import netCDF4  # the other readers do without it

    with netCDF4.Dataset("links", memory=content) as file:
        sent, got = (np.ma.filled(file[name][:, link, :].astype(float), np.nan) for name in ("tsl", "rsl"))
    loss = np.where(np.abs(sent - got) < 200, sent - got, np.nan)
    return loss.reshape(2, -1, 5).mean(axis=2)


def neutron_station(content):
    """Forty days of a neutron probe that writes a file an event, from a zip archive: its numbers by name, in the order of time, and seconds since the first row."""
    names = "number when P1 P3 P4 T1 T2 T3 T4 TCS RH1 RH2 RHCS Vb N1 N2 e1 e2 N1T N1RH N2T N2RH D1".split()
    with zipfile.ZipFile(io.BytesIO(content)) as file:
        lines = [line.split(",")[: len(names)] for name in sorted(file.namelist()) for line in file.read(name).decode("latin1").splitlines() if line[:1].isdigit()]
    frame = pd.DataFrame([line for line in lines if len(line) == len(names)], columns=names)
    when = pd.to_datetime(frame.pop("when").str.strip(), format="%Y/%m/%d %H:%M:%S", errors="coerce")
    frame = frame.apply(pd.to_numeric, errors="coerce").assign(when=when).dropna().drop_duplicates("number").sort_values("when")
    frame = frame[(frame.when >= "2017-03-01") & (frame.when < "2017-04-10")]
    return frame.assign(time_s=seconds(frame.when))


def indenter(content):
    """The table of an indentation file, under its header of settings; what follows the table is left away."""
    text = content.decode("latin1")
    lines = text[text.index("Time_s\t") :].splitlines()
    cells = [line.split("\t") for line in lines]
    kept = [row for row in cells[1:] if len(row) == len(cells[0]) and row[0][:1].isdigit()]
    return pd.DataFrame([[float(v) for v in row] for row in kept], columns=cells[0])


def array(content):
    """An array of numpy that holds numbers only."""
    return np.load(io.BytesIO(content), allow_pickle=False)


def earth(content, first, days, name):
    """Seconds since a modified Julian date, and one column of the Earth's orientation by the day: `X`, `UT1` or `LOD`."""
    lines = [line.split() for line in content.decode().splitlines() if line[:1] != "#"]
    table = np.array([[float(v) for v in line[:13]] for line in lines])
    kept = table[(table[:, 4] >= first) & (table[:, 4] < first + days)]
    return (kept[:, 4] - first) * 86400, kept[:, {"X": 5, "UT1": 7, "LOD": 12}[name]]


def soil_logger(content):
    """The first 3000 rows of a soil logger that writes a file an event, from a zip archive: seconds since the first row, and numbers by the place of their column."""
    with zipfile.ZipFile(io.BytesIO(content)) as file:
        lines = [line.split() for name in sorted(file.namelist()) if name.endswith("TXT") for line in file.read(name).decode("latin1").splitlines()]
    frame = pd.DataFrame([line for line in lines if len(line) == 24]).drop(columns=[7, 22, 23]).apply(pd.to_numeric, errors="coerce")
    frame = frame.dropna().drop_duplicates(1).sort_values(1).iloc[:3000]
    return frame[1] - frame[1].iloc[0], frame


def counter(content):
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


def dinkum(content, listing=None):
    """A file of a glider's computer (Dinkum binary data) as a data frame: a row a cycle, nan where a sensor said nothing. Where the file does not name its sensors, `listing` does."""
    tags = dict(line.split(":", 1) for line in content[:2000].decode("latin1").splitlines()[:14])
    lines = content.split(b"\n", 14 + (int(tags["total_num_sensors"]) if listing is None else 0))
    at = len(content) - len(lines[-1])
    told = (line.split() for line in (b"\n".join(lines[14:-1]) if listing is None else listing).decode("latin1").splitlines() if line.startswith("s:"))
    sensors = sorted((int(place), int(size), name) for _, _, _, place, size, name, _ in told if int(place) >= 0)
    order = "<" if struct.unpack("<h", content[at + 2 : at + 4])[0] == 0x1234 else ">"
    states, at = int(tags["state_bytes_per_cycle"]), at + 16
    now, rows = [np.nan] * len(sensors), []
    while content[at : at + 1] == b"d":
        state, at, row = content[at + 1 : at + 1 + states], at + 1 + states, [np.nan] * len(sensors)
        for k, (_, size, _) in enumerate(sensors):
            what = state[k // 4] >> (6 - 2 * (k % 4)) & 3
            if what == 2:
                now[k] = struct.unpack(order + {1: "b", 2: "h", 4: "f", 8: "d"}[size], content[at : at + size])[0]
                at += size
            if what:
                row[k] = now[k]
        rows.append(row)
    return pd.DataFrame(rows, columns=[name for *_, name in sensors])


def glider_rows(frame, *names):
    """Rows of a glider in which all these sensors have numbers, with seconds since the first."""
    kept = frame.dropna(subset=["m_present_time", *names])
    return kept.assign(time_s=kept.m_present_time - kept.m_present_time.iloc[0])


def scans(content):
    """The scans of a SPEC file, each as a data frame with the number of its scan."""
    for scan in re.split(r"\n(?=#S )", content.decode("latin1"))[1:]:
        labels = re.search(r"^#L (.*)$", scan, re.M)
        names = re.split(r"\s{2,}", labels[1].strip()) if labels else []
        cells = [line.split() for line in scan.splitlines() if line[:1] in "-0123456789" and line]
        kept = [[float(v) for v in row] for row in cells if len(row) == len(names)]
        frame = pd.DataFrame(kept, columns=names)
        yield frame.loc[:, ~frame.columns.duplicated()].assign(scan=int(scan.split()[1]))


def beamline(content):
    """Every second point of all scans of a SPEC file, with seconds since the first."""
    frame = pd.concat(scans(content)).iloc[::2]
    return frame.assign(time_s=frame.Epoch - frame.Epoch.iloc[0])


def fibre(content):
    """The cable of a fibre that measures temperature, 1 to 99 m: length, light of the two lines scattered from either end, temperature by the instrument."""
    rows = [[float(v) for v in line.split(",")] for line in re.findall(r"<data>([^<]*)</data>", content.decode())]
    frame = pd.DataFrame(rows, columns=["along", "stokes", "anti", "back_stokes", "back_anti", "degc"])
    return frame[frame.along.between(1, 99)]


def heat_flow_meter(content):
    """Blocks of a heat flow meter: temperature of the upper and the lower plate, and what their transducers read; without the first ones, which are out of range."""
    found = re.findall(r"^\s*-[a-z]+-\s+(\S+)\s+(\S+)\s+(\S+)\s+(\S+)\s+\S+\s*$", content.decode("utf-16"), re.M)
    frame = pd.DataFrame([[float(v) for v in row] for row in found], columns=["upper_c", "lower_c", "upper_uv", "lower_uv"])
    return frame[(frame.upper_uv.abs() < 19500) & (frame.lower_uv.abs() < 19500)].reset_index(drop=True)


def collectors(content, first, last, every):
    """Rows of a field of solar collectors from one time to another, one of `every` minutes, with seconds since the first."""
    frame = csv(content, sep=";")
    when = pd.to_datetime(frame.timestamps_UTC)
    frame = frame.assign(when=when)[(when >= first) & (when < last)].iloc[::every].dropna()
    return frame.assign(time_s=seconds(frame.when))


def poses(content):
    """Places of a camera, one a picture, from the last column of the first three rows of each pose."""
    return np.array([[float(v) for v in line.split()] for line in content.decode().splitlines()])[:, [3, 7, 11]]


def track(content):
    """Times, places and turns of a camera, one row each; lines that begin with # are comments."""
    return np.array([[float(v) for v in line.split()] for line in content.decode().splitlines() if line[:1] != "#"])
