"""Files that are packed, as zip or gzip."""

import io
import zipfile


def names_in_zip(content):
    """Names of the files in a zip archive."""
    with zipfile.ZipFile(io.BytesIO(content)) as file:
        return file.namelist()


def in_zip(content, name):
    """Bytes of a file in a zip archive."""
    with zipfile.ZipFile(io.BytesIO(content)) as file:
        return file.read(name)
