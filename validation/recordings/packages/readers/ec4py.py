"""Reads files of the package ec4py."""

import struct

import numpy as np

TDMS_KINDS = {1: "i1", 2: "<i2", 3: "<i4", 4: "<i8", 5: "u1", 6: "<u2", 7: "<u4", 8: "<u8", 9: "<f4", 10: "<f8", 0x21: "u1"}


def tdms(content):
    """Channels of numbers of a TDMS file, by the last part of their names, up to the first channel of text."""
    at, found, order, known = 0, {}, [], {}

    def text(at):
        size = struct.unpack_from("<I", content, at)[0]
        return content[at + 4 : at + 4 + size].decode("latin1"), at + 4 + size

    while content[at : at + 4] == b"TDSm":
        flags, _, size, raw = struct.unpack_from("<IIQQ", content, at + 4)
        begin, end, here = at + 28 + raw, min(len(content), at + 28 + size), at + 28
        if flags & 2:
            order = [] if flags & 4 else order
            objects, here = struct.unpack_from("<I", content, here)[0], here + 4
            for _ in range(objects):
                path, here = text(here)
                index, here = struct.unpack_from("<I", content, here)[0], here + 4
                if index not in (0, 0xFFFFFFFF):
                    known[path] = struct.unpack_from("<IIQ", content, here)[::2]
                    here += index - 4
                if index != 0xFFFFFFFF and path not in order:
                    order.append(path)
                properties, here = struct.unpack_from("<I", content, here)[0], here + 4
                for _ in range(properties):
                    _, here = text(here)
                    kind, here = struct.unpack_from("<I", content, here)[0], here + 4
                    here = text(here)[1] if kind == 0x20 else here + (16 if kind == 0x44 else np.dtype(TDMS_KINDS[kind]).itemsize)
        while flags & 8 and order and begin < end:
            for path in order:
                kind, count = known[path]
                if kind not in TDMS_KINDS:
                    return found
                values = np.frombuffer(content, TDMS_KINDS[kind], count, begin)
                name = path.split("/")[-1].strip("'")
                begin, found[name] = begin + values.nbytes, np.append(found.get(name, np.empty(0)), values)
        at = end
    return found
