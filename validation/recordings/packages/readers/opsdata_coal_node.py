"""Reads files of the package opsdata-coal-node."""

import struct

import numpy as np


def geophones(content, rows, hertz, **stations):
    """The first rows of the vertical channels of some stations, from miniSEED of floating numbers, by the names that they are to have."""
    at, found = 0, {}
    while at < len(content):
        many, begin = struct.unpack_from(">H", content, at + 30)[0], struct.unpack_from(">H", content, at + 44)[0]
        if content[at + 15 : at + 18] == b"DPZ":
            found.setdefault(content[at + 8 : at + 13].decode().strip(), []).append(np.frombuffer(content, ">f4", many, at + begin))
        at += 1 << content[at + 54]
    return {"time_s": np.arange(rows) / hertz, **{name: np.concatenate(found[station])[:rows].astype(float) for name, station in stations.items()}}
