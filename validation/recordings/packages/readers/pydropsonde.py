"""Reads files of the package pydropsonde."""

import pandas as pd


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
