"""Reads files of the package dbdreader."""

import struct

import numpy as np
import pandas as pd


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
