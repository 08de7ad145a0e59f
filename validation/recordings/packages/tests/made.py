"""A small archive, its list and its recording, made for a test."""

import hashlib
import importlib.util
import io
import tarfile
from types import SimpleNamespace

import numpy as np
import sources

SCIPY = importlib.util.find_spec("scipy")
READS = SCIPY and importlib.util.find_spec("pandas")
ROWS = b"1 10\n2 20\n3 31\n"
CSV = "x,y\n1,10\n2,20\n3,31\n"


def told(columns):
    """Columns as lists of plain numbers."""
    return {name: np.round(np.asarray(values, float), 6).tolist() for name, values in columns.items()}


def written(table, **options):
    """A table of numbers as the bytes of a file."""
    out = io.BytesIO()
    np.savetxt(out, table, **{"delimiter": ",", **options})
    return out.getvalue()


def matlab(**variables):
    """A MATLAB file of variables, as bytes."""
    from scipy.io import savemat

    out = io.BytesIO()
    savemat(out, variables)
    return out.getvalue()


def left_by(y, models):
    """What each model leaves of a column when it sees all rows: a standard deviation."""
    seen = np.ones(len(y), bool)
    return {name: np.std(y - model(seen)) for name, model in models.items()}


def archive(folder, name="pack-1.0.tar.gz", inside="pack-1.0/rows.txt", content=ROWS):
    """Writes an archive and returns how it is listed."""
    folder.mkdir(parents=True, exist_ok=True)
    with tarfile.open(folder / name, "w:gz") as out:
        member = tarfile.TarInfo(inside)
        member.size = len(content)
        out.addfile(member, io.BytesIO(content))
    digest = hashlib.sha256((folder / name).read_bytes()).hexdigest()
    return sources.Archive("pack", "1.0", name, digest, "MIT")


def rows(content):
    """How the rows of the archive are read."""
    pairs = [[int(v) for v in line.split()] for line in content.decode().splitlines()]
    return {"x": [pair[0] for pair in pairs], "y": [pair[1] for pair in pairs]}


class Recording(sources.Recording):
    """A recording whose description and reader lie with the test."""

    home = None

    @property
    def description(self):
        return self.home / f"{self.name}.toml"

    def module(self):
        return SimpleNamespace(rows=rows)


def recording(folder, archive, csv=CSV, description='schema = "truegap.recording/1"\nfile = "made.csv"\n'):
    """A recording of that archive, described in a folder."""
    (folder / "made.toml").write_text(description)
    digest = hashlib.sha256(csv.encode()).hexdigest()
    made = Recording("made", "first", archive, ("pack-1.0/rows.txt",), "pack 1.0, rows.txt", "nothing", 8, digest)
    object.__setattr__(made, "home", folder)
    return made
