"""Reads sources.toml and the descriptions: which archive holds which recording, and what the bytes must be."""

import importlib.util
import re
import tomllib
from dataclasses import dataclass
from pathlib import Path

from problem import Problem

HERE = Path(__file__).resolve().parent
SCHEMA = "truegap.recording/1"
SHA256 = re.compile(r"[0-9a-f]{64}")


@dataclass(frozen=True)
class Archive:
    """A published file of one package."""

    package: str
    version: str
    file: str
    sha256: str
    licence: str

    @property
    def is_wheel(self):
        return self.file.endswith(".whl")


@dataclass(frozen=True)
class Recording:
    """One recording inside of an archive; `digits` are those of a number in its CSV."""

    name: str
    set: str
    archive: Archive
    inside: tuple
    source: str
    missing: str
    digits: int
    csv_sha256: str

    @property
    def description(self):
        return HERE / "recordings" / f"{self.name}.toml"

    def module(self):
        """The file that says how its rows are read and which models were built by hand."""
        path = HERE / "recordings" / f"{self.name}.py"
        spec = importlib.util.spec_from_file_location(self.name.replace("-", "_"), path)
        if not path.is_file():
            raise Problem(f"{path} is missing; it says how {self.name} is read")
        module = importlib.util.module_from_spec(spec)
        try:
            spec.loader.exec_module(module)
        except ModuleNotFoundError as error:
            raise Problem(f"{error.name} is not installed; `pip install -r {HERE / 'requirements.txt'}`") from error
        return module


def toml(path):
    """A TOML file as a table."""
    try:
        return tomllib.loads(Path(path).read_text(encoding="utf-8"))
    except OSError as error:
        raise Problem(f"{path}: {error.strerror}") from error
    except (tomllib.TOMLDecodeError, UnicodeDecodeError) as error:
        raise Problem(f"{path} is no TOML: {error}") from error


def recordings(path=HERE / "sources.toml"):
    """All recordings of a list, in its order, by name."""
    table = toml(path)
    digits = {name: one["digits"] for name, one in table.get("set", {}).items()}
    archives, found = {}, {}
    for entry in table.get("archive", []):
        keep(entry, ("package", "version", "file", "sha256", "licence"), f"{path}: [[archive]] {entry.get('file', '')}")
        checked_hash(entry["sha256"], f"{path}: {entry['file']}")
        if Path(entry["file"]).name != entry["file"]:
            raise Problem(f"{path}: `{entry['file']}` is not the name of a file but a path; an archive lies in one folder")
        archives[entry["file"]] = Archive(**entry)
    for entry in table.get("recording", []):
        where = f"{path}: [[recording]] {entry.get('name', '')}"
        keep(entry, ("name", "set", "archive", "inside", "source", "missing", "csv_sha256"), where)
        checked_hash(entry["csv_sha256"], where)
        if entry["archive"] not in archives:
            raise Problem(f"{where}: no [[archive]] has the file `{entry['archive']}`")
        if entry["set"] not in digits:
            raise Problem(f"{where}: no [set.{entry['set']}]")
        if entry["name"] in found:
            raise Problem(f"{where} is there twice")
        parts = {**entry, "archive": archives[entry["archive"]], "inside": tuple(entry["inside"])}
        found[entry["name"]] = Recording(**parts, digits=digits[entry["set"]])
    if not found:
        raise Problem(f"{path} lists no [[recording]]")
    return found


def chosen(everything, names):
    """The recordings with these names; all where no name is given."""
    unknown = [name for name in names if name not in everything]
    if unknown:
        raise Problem(f"no recording is called {', '.join(unknown)}; `fetch.py --list` shows the names")
    return [everything[name] for name in names or everything]


def description(recording, path=None):
    """The text of a description, checked: its schema, and that it describes the CSV that is written beside it."""
    path = path or recording.description
    table = toml(path)
    if table.get("schema") != SCHEMA:
        raise Problem(f"{path}: schema is `{table.get('schema')}`; a recording's is `{SCHEMA}`")
    if table.get("file") != f"{recording.name}.csv":
        raise Problem(f"{path}: file is `{table.get('file')}`; it must be `{recording.name}.csv`")
    return Path(path).read_text(encoding="utf-8")


def keep(entry, keys, where):
    """An entry has these keys and no other."""
    missing, unknown = [k for k in keys if k not in entry], [k for k in entry if k not in keys]
    if missing or unknown:
        raise Problem(f"{where}: " + "; ".join([f"`{k}` is missing" for k in missing] + [f"`{k}` is no key here" for k in unknown]))


def checked_hash(text, where):
    """Text that can be a SHA-256."""
    if not isinstance(text, str) or not SHA256.fullmatch(text):
        raise Problem(f"{where}: `{text}` is no SHA-256, which has 64 digits of 0-9 and a-f")
