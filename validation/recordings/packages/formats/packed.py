"""Files that are packed, as zip or gzip."""

import gzip
import io
import zipfile


def all_in_zip(content):
    """Bytes of all files in a zip archive by their names, in the order of the names."""
    with zipfile.ZipFile(io.BytesIO(content)) as file:
        return {name: file.read(name) for name in sorted(file.namelist())}


def in_zip(content, name):
    """Bytes of a file in a zip archive."""
    with zipfile.ZipFile(io.BytesIO(content)) as file:
        return file.read(name)


def unpacked(content):
    """What a file holds, whether it is packed by gzip or not."""
    return gzip.decompress(content) if content[:2] == b"\x1f\x8b" else content
