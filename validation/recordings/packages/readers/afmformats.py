"""Reads files of the package afmformats."""

import io
import zipfile

import numpy as np


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
