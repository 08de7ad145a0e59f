"""Formats that several recordings share, from bytes to columns."""

import gzip
import io
import json
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


def flight(content):
    """Positions of an aircraft by time, from gzipped JSON: its numbers by name, and seconds since the first row."""
    cells = json.loads(gzip.decompress(content))
    frame = pd.DataFrame(cells).sort_values("timestamp").drop_duplicates("timestamp").reset_index(drop=True)
    return frame.assign(time_s=(frame.timestamp - frame.timestamp.iloc[0]) / 1000)


NGB_RECORD = re.compile(rb"\x18\xfc\xff\xff\x03\x80\x01(..)\x00\x00\x01\x00\x00\x00\x0c\x00\x17\xfc\xff\xff(.)(\x80\x01|\xa0\x01)", re.S)
NGB_CHANNELS = {0x8C: "minutes", 0x8D: "sample_c", 0x8E: "heat_flow_uv", 0x8F: "length_um", 0x90: "mass_mg", 0x30: "furnace_c", 0x32: "power"}


def thermal_analysis(content, run=0):
    """Channels of a thermobalance or a dilatometer by name, from the tables of its file; of two runs in one file the first is the sample, the second the correction."""
    found, now = {}, None
    with zipfile.ZipFile(io.BytesIO(content)) as file:
        tables = [file.read(f"Streams/stream_{number}.table") for number in (2, 3)]
    for raw in tables:
        at = 0
        while record := NGB_RECORD.search(raw, at):
            field, kind, at = struct.unpack("<H", record[1])[0], record[2][0], record.end()
            if record[3] == b"\xa0\x01" and (field, kind) in {(0x0F40, 5), (0x0F3D, 4)}:
                values = np.frombuffer(raw, "<f8" if kind == 5 else "<f4", struct.unpack_from("<I", raw, at)[0], at + 4)
                now.append(values)
                at += 4 + values.nbytes
            elif kind == 0x1A and (tag := raw.find(b"\x02\x00\x00\x80", at, at + 64)) >= 0 and raw[tag + 4 : tag + 6] == b"\x22\x2b":
                now = []
                found.setdefault(NGB_CHANNELS.get(field & 0xFF), []).append(now)
    return pd.DataFrame({name: np.concatenate(runs[run]).astype(float) for name, runs in found.items() if name and runs[run]})


FITS_KINDS = {"D": ">f8", "E": ">f4", "J": ">i4", "I": ">i2", "B": "u1", "A": "S1", "L": "u1"}


def repeated(first, second, every):
    """The same programme of a thermobalance twice, `every` so many readings, as long as both last."""
    one, two = (thermal_analysis(content).iloc[::every] for content in (first, second))
    rows = min(len(one), len(two))
    return one.iloc[:rows], two.iloc[:rows]


def isotopes(content, first):
    """Counts of a mass spectrometer by isotope, from where that of the `first` is there."""
    frame = csv(content, skiprows=3).dropna()
    return frame[frame[first].notna()].astype(float)


def fits_tables(content):
    """Binary tables of a FITS file by their names, each an array with named fields."""
    at, found = 0, {}
    while at < len(content):
        end = at
        while not any(content[k : k + 8] == b"END     " for k in range(end, end + 2880, 80)):
            end += 2880
        end += 2880
        cards = [content[k : k + 80].decode("latin1") for k in range(at, end, 80)]
        told = {card[:8].strip(): card[10:].split(" /")[0].strip(" '") for card in cards if card[8:10] == "= "}
        axes = [int(told[f"NAXIS{k}"]) for k in range(1, int(told["NAXIS"]) + 1)]
        if told.get("XTENSION") == "BINTABLE":
            forms = [re.match(r"(\d*)([A-Z])", told[f"TFORM{k}"]) for k in range(1, int(told["TFIELDS"]) + 1)]
            kinds = [(told[f"TTYPE{k}"], FITS_KINDS[form[2]], (int(form[1] or 1),)) for k, form in enumerate(forms, 1)]
            found[told["EXTNAME"]] = np.frombuffer(content, np.dtype(kinds), axes[1], end)
        size = int(np.prod(axes)) * abs(int(told["BITPIX"])) // 8 if axes else 0
        at = end + -(-size // 2880) * 2880
    return found


STEIM = {(1, 0): (4, 8), (2, 1): (1, 30), (2, 2): (2, 15), (2, 3): (3, 10), (3, 0): (5, 6), (3, 1): (6, 5), (3, 2): (7, 4)}


def seismogram(content, rows):
    """The first samples of one channel of miniSEED that is packed by Steim's second way and has no gap."""
    out, at = np.empty(0), 0
    while len(out) < rows:
        count, begin = struct.unpack_from(">H", content, at + 30)[0], struct.unpack_from(">H", content, at + 44)[0]
        length = 1 << content[at + 54]
        words = np.frombuffer(content, ">u4", (length - begin) // 4, at + begin).reshape(-1, 16).tolist()
        steps = []
        for frame in words:
            for k, word in enumerate(frame[1:], 1):
                if kind := frame[0] >> (30 - 2 * k) & 3:
                    many, bits = STEIM[kind, 0 if kind == 1 else word >> 30]
                    parts = [word >> bits * (many - 1 - j) & (1 << bits) - 1 for j in range(many)]
                    steps += [part - (1 << bits) if part >> (bits - 1) else part for part in parts]
        steps[0] = struct.unpack_from(">i", content, at + begin + 4)[0]
        out = np.append(out, np.cumsum(steps[:count]))
        at += length
    return out[:rows]


def cytometer(content):
    """Events of a flow cytometer file of floating numbers (FCS), by the names of its channels."""
    first, last, data = int(content[10:18]), int(content[18:26]), int(content[26:34])
    text = content[first : last + 1].decode("latin1")
    words = text[1:].split(text[0])
    told = dict(zip(words[::2], words[1::2]))
    channels, events = int(told["$PAR"]), int(told["$TOT"])
    values = np.frombuffer(content, ("<" if told["$BYTEORD"][0] == "1" else ">") + {"F": "f4", "D": "f8"}[told["$DATATYPE"]], channels * events, data)
    return pd.DataFrame(values.reshape(events, channels).astype(float), columns=[told[f"$P{k}N"] for k in range(1, channels + 1)])


def trackpoints(content):
    """Points of a training file (TCX) that have all of time, place, heart rate, speed and power: numbers by name, and seconds since the first."""
    tags = {"when": "Time", "north": "LatitudeDegrees", "east": "LongitudeDegrees", "heart": "Value", "speed": "ns3:Speed", "watts": "ns3:Watts"}
    points = re.findall(r"<Trackpoint>(.*?)</Trackpoint>", content.decode(), re.S)
    found = [[re.search(rf"<{tag}>([^<]*)<", point) for tag in tags.values()] for point in points]
    frame = pd.DataFrame([[cell[1] for cell in row] for row in found if all(row)], columns=list(tags))
    when = pd.to_datetime(frame.pop("when"))
    return frame.astype(float).assign(time_s=seconds(when))


def diver(content):
    """A water level logger (a diver) or its barometer: pressure in hPa, temperature, and the time of each row; lines that are not whole are left away."""
    lines = [line.split(",") for line in content.decode("latin1").splitlines() if line[:2] == "20"]
    frame = pd.DataFrame([line for line in lines if len(line) == 3], columns=["when", "pressure", "degc"])
    numbers = frame[["pressure", "degc"]].apply(pd.to_numeric, errors="coerce")
    return numbers.assign(when=pd.to_datetime(frame.when), pressure=numbers.pressure * 0.980665).dropna()


def wells(first, second, barometer):
    """Hours in which two divers, `_1` and `_2`, are under water and their barometer has a number."""
    both = diver(first).merge(diver(second), on="when", suffixes=("_1", "_2")).merge(diver(barometer), on="when")
    return both[(both.pressure_1 > 1080) & (both.pressure_2 > 1080)]


def well_log(content):
    """The curves of a well log (LAS), rows that have a number in all of them."""
    lines = content.decode("latin1").splitlines()
    curves, data = (next(k for k, line in enumerate(lines) if line.startswith(mark)) + 1 for mark in ("~C", "~A"))
    ends = next(k for k in range(curves, data) if lines[k].startswith("~"))
    names = [line.split(".")[0].strip() for line in lines[curves:ends] if line.strip() and line[0] != "#"]
    frame = pd.DataFrame([[float(v) for v in line.split()] for line in lines[data:] if line.strip()], columns=names)
    return frame[~frame.isin([-99999, -999.25]).any(axis=1)]


def dropsonde(content):
    """What a dropsonde sends twice a second once it counts itself as dropped: pressure, temperature, height by pressure and by satellites, speed upwards, and seconds of the day."""
    sent = [line.split() for line in content.decode("latin1").splitlines() if line.startswith("AVAPS-D")]
    names = ["clock", "hpa", "degc", "humidity", "from_deg", "wind", "up_m_s", "east", "north", "height", "places", "rh1", "rh2", "sonde_places", "error", "gps_height"]
    fallen = [line for line in sent if line[1][0] == "S"]
    frame = pd.DataFrame([[float(v) for v in line[4:20]] for line in fallen], columns=names)
    at = frame.clock // 10000 * 3600 + frame.clock // 100 % 100 * 60 + frame.clock % 100
    return frame.assign(at=at, sonde=[line[2] for line in fallen])[(frame.hpa < 9000) & (frame.degc < 90) & (frame.humidity < 900)]


def without_spikes(frame, **limits):
    """Rows whose columns are so near to the middle of the nine rows around them."""
    for name, limit in limits.items():
        frame = frame[(frame[name] - frame[name].rolling(9, center=True, min_periods=1).median()).abs() < limit]
    return frame


def fall(content, first=60):
    """The fall of a dropsonde without its first thirty seconds and without numbers that were received wrongly, with seconds since its first row."""
    frame = dropsonde(content)
    whole = frame[(frame.gps_height < 9e4) & (frame.height < 9e4) & (frame.up_m_s < 90)].iloc[first:]
    whole = without_spikes(whole, gps_height=40, hpa=3, up_m_s=6, degc=2)
    return whole.assign(time_s=whole["at"] - whole["at"].iloc[0])


def cabin(content):
    """A dropsonde that stays in its aircraft: every second row, from 17:40 on."""
    frame = dropsonde(content)
    frame = without_spikes(frame[(frame.sonde == frame.sonde.mode()[0]) & (frame["at"] > 63600)], degc=0.3, hpa=3).iloc[::2]
    return frame.assign(time_s=frame["at"] - frame["at"].iloc[0])


def eddy_station(content):
    """The first 6000 rows, five minutes, of an anemometer and a gas analyser that are read 20 times a second."""
    frame = csv(content, skiprows=[0, 2, 3]).iloc[:6000]
    return frame.assign(time_s=np.arange(len(frame)) / 20)


def joint(position, other, name, what):
    """One joint of a robot from 10 to 66 s, every second of its readings: seconds, position, and another column. Before and after its file is filled in by curves."""
    where, beside = csv(position).iloc[::2], csv(other).iloc[::2]
    kept = (where.t >= 10) & (where.t < 66)
    return where.t[kept] - 10, where[f"- {name}_joint_position"][kept], beside[f"- {name}_joint_{what}"][kept]


def cycler(content):
    """Rows of a battery cycler: seconds, current, voltage and what it does."""
    lines = [line.split(",") for line in content.decode("latin1").splitlines() if line[:3] == "No,"]
    frame = pd.DataFrame([[float(line[k]) for k in (1, 8, 9)] for line in lines], columns=["time_s", "ampere", "volt"])
    return frame.assign(mode=[line[13] for line in lines])
