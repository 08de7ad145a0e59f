"""Reads files of the package pyngb."""

import re
import struct

import numpy as np
import pandas as pd
from formats.packed import in_zip

NGB_RECORD = re.compile(rb"\x18\xfc\xff\xff\x03\x80\x01(..)\x00\x00\x01\x00\x00\x00\x0c\x00\x17\xfc\xff\xff(.)(\x80\x01|\xa0\x01)", re.S)
NGB_CHANNELS = {0x8C: "minutes", 0x8D: "sample_c", 0x8E: "heat_flow_uv", 0x8F: "length_um", 0x90: "mass_mg", 0x30: "furnace_c", 0x32: "power"}


def thermal_analysis(content, run=0):
    """Channels of a thermobalance or a dilatometer by name, from the tables of its file; of two runs in one file the first is the sample, the second the correction."""
    found, now = {}, None
    for raw in (in_zip(content, f"Streams/stream_{number}.table") for number in (2, 3)):
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


def programme_twice(first, second, every):
    """The same programme of a thermobalance twice, `every` so many readings, as long as both last."""
    one, two = (thermal_analysis(content).iloc[::every] for content in (first, second))
    rows = min(len(one), len(two))
    return one.iloc[:rows], two.iloc[:rows]
