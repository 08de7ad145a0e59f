"""Recordings as people have them: a path, a pandas or polars frame, a dict of arrays."""

from __future__ import annotations

import json
import os
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any, Protocol, Union, cast

import numpy as np

if TYPE_CHECKING:
    from ._truegap import Columns, Source


class Frame(Protocol):
    """A table with named columns: pandas and polars frames, pyarrow tables are some."""

    def __getitem__(self, name: Any, /) -> Any: ...


Path = Union[str, "os.PathLike[str]"]
Recording = Union[Path, Frame, Mapping[str, Any]]

#: Endings of files that hold a frame instead of text.
COLUMNAR = (".parquet", ".feather", ".arrow", ".ipc")
#: Column that stands for a reading that was not made, where only inputs matter.
NO_READING = "truegap: no reading"


def names(frame: Recording) -> list[str]:
    """Names of a frame's columns."""
    found = getattr(frame, "column_names", None) or getattr(frame, "columns", None)
    if found is None and hasattr(frame, "keys"):
        found = frame.keys()
    if found is None:
        raise TypeError(f"a {type(frame).__name__} is no recording; give a path, a pandas or polars frame, or a dict of arrays")
    return [str(name) for name in found]


def numeric(column: Any) -> np.ndarray[Any, np.dtype[np.float64]] | None:
    """The column as 64-bit floats, without a copy where it is that already; ``None`` where it holds no numbers."""
    array = np.asarray(column)
    if array.dtype.kind in "mM":
        raise TypeError("a column of dates is no clock; give seconds, as in (t - t[0]).total_seconds()")
    if array.dtype.kind not in "biufO":
        return None
    try:
        return np.ascontiguousarray(array, dtype=np.float64)
    except (TypeError, ValueError):
        return None


def is_text(recording: Recording) -> bool:
    """Whether it is a path that the native half reads: its TOML says what frames are told by ``columns``, ``units`` and ``drivers``."""
    return isinstance(recording, (str, os.PathLike)) and not os.fspath(recording).lower().endswith(COLUMNAR)


def _columnar(path: str) -> Frame:
    """The frame in a Parquet or Arrow (Feather) file, by pyarrow or polars, whichever is installed."""
    parquet = path.lower().endswith(".parquet")
    try:
        if parquet:
            from pyarrow.parquet import read_table
        else:
            from pyarrow.feather import read_table
        return cast(Frame, read_table(path))
    except ImportError:
        pass
    try:
        import polars
    except ImportError:
        raise TypeError(f"{path}: to read it, pyarrow or polars is needed: pip install pyarrow") from None
    return cast(Frame, polars.read_parquet(path) if parquet else polars.read_ipc(path))


def source(
    recording: Recording,
    *,
    name: str,
    columns: Mapping[str, str] | None,
    units: Mapping[str, str] | None,
    drivers: Mapping[str, Mapping[str, str]] | None,
    base: Mapping[str, Any] | None,
    reading: bool = True,
) -> Source:
    """The recording as the native half reads it; ``reading`` says whether the response matters."""
    if isinstance(recording, (str, os.PathLike)) and not is_text(recording):
        name, recording = os.fspath(recording), _columnar(os.fspath(recording))
    if isinstance(recording, (str, os.PathLike)):
        if columns or units or drivers:
            raise TypeError("columns, units and drivers of a file stand in its TOML; give them with a frame, or write a TOML")
        return recording
    roles, measured = dict(columns or {}), dict(units or {})
    table: Columns = []
    left_out: list[str] = []
    for column in names(recording):
        numbers = numeric(_column(recording, column))
        if numbers is None or numbers.ndim != 1:
            left_out.append(column)
        else:
            table.append((column, numbers))
    if not reading:
        table = _without_reading(table, roles.get("response"))
        roles["response"], measured["response"] = NO_READING, "1"
    says: dict[str, Any] = {"schema": "truegap.recording/1", "file": name, "columns": roles, "units": measured}
    says["drivers"] = {key: dict(value) for key, value in (drivers or {}).items()}
    if base is not None:
        says["base"] = dict(base)
    wanted = [c for c in roles.values() if c in left_out]
    if wanted:
        raise TypeError(f"the column `{wanted[0]}` of the frame holds no numbers")
    return name, json.dumps(says), table


def _column(frame: Any, name: str) -> Any:
    column = frame[name]
    return column.to_numpy() if hasattr(column, "to_numpy") else column


def _without_reading(table: Columns, response: str | None) -> Columns:
    rows = len(table[0][1]) if table else 0
    kept = [(name, column) for name, column in table if name != response]
    return [*kept, (NO_READING, np.zeros(rows))]


def list_of(recordings: Recording | Sequence[Recording]) -> list[Recording]:
    """One recording or several, as a list."""
    if isinstance(recordings, (list, tuple)):
        return list(recordings)
    return [recordings]
