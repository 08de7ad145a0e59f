"""Recordings as people have them: a path, a pandas or polars frame, a dict of arrays."""

from __future__ import annotations

import datetime as dt
import json
import os
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any, Protocol, Union

import numpy as np

from . import _truegap

if TYPE_CHECKING:
    from ._truegap import FrameColumns, Source


class Frame(Protocol):
    """A table with named columns: pandas and polars frames, pyarrow tables are some."""

    def __getitem__(self, name: Any, /) -> Any: ...


Path = Union[str, "os.PathLike[str]"]
Recording = Union[Path, Frame, Mapping[str, Any]]

#: Endings of files that hold a frame instead of text.
COLUMNAR = (".parquet", ".feather", ".arrow", ".ipc")
#: The word for the built-in recording.
EXAMPLE = "example"
#: Names of columns that are clocks where they hold dates.
CLOCKS = ("time", "timestamp", "date", "datetime")
#: Values, and what they are seconds since; an empty text for durations.
Cells = tuple["np.ndarray[Any, np.dtype[np.float64]]", Union[str, None]]
#: Column that stands for a reading that was not made, where only inputs matter.
NO_READING = "truegap: no reading"


def names(frame: Recording) -> list[str]:
    """Names of a frame's columns."""
    found = getattr(frame, "column_names", None)
    found = getattr(frame, "columns", None) if found is None else found
    if found is None and isinstance(frame, Mapping):
        found = frame.keys()
    if found is None:
        found = getattr(getattr(frame, "dtype", None), "names", None)
    if found is None:
        raise TypeError(f"a {type(frame).__name__} is no recording; give a path, a pandas or polars frame, or a dict of arrays")
    return [str(name) for name in found]


def numeric(column: Any, zoned: bool = False) -> Cells | None:
    """The column as 64-bit floats, without a copy where it is that already; ``None`` where it holds neither numbers nor times.

    Dates become seconds since the whole second of the first, which is the second value; durations become seconds, and the second value is empty.
    """
    array = np.asarray(column)
    if array.dtype.kind == "O":
        array, zoned = _objects(array, zoned)
    if array.dtype.kind == "M":
        return _since_first(array, zoned)
    if array.dtype.kind == "m":
        ticks = array.astype("timedelta64[ns]")
        return np.where(np.isnat(ticks), np.nan, ticks.astype(np.int64) / 1e9), ""
    if array.dtype.kind not in "biufOU":
        return None
    try:
        return np.ascontiguousarray(array, dtype=np.float64), None
    except (TypeError, ValueError):
        return None


def _objects(array: np.ndarray[Any, Any], zoned: bool) -> tuple[np.ndarray[Any, Any], bool]:
    """Dates of the standard library as numpy has them, in Greenwich where they have a zone; anything else as it stands."""
    first = next((cell for cell in array.flat if cell is not None and cell == cell), None)
    if isinstance(first, dt.timedelta):
        return array.astype("timedelta64[us]"), zoned
    if not isinstance(first, dt.date):
        return array, zoned
    zoned = zoned or getattr(first, "tzinfo", None) is not None

    def plain(cell: Any) -> Any:
        if cell is None or cell != cell:
            return None
        aware = getattr(cell, "tzinfo", None) is not None
        return cell.astimezone(dt.timezone.utc).replace(tzinfo=None) if aware else cell

    return np.array([plain(cell) for cell in array], dtype="datetime64[us]"), zoned


def _since_first(dates: np.ndarray[Any, Any], zoned: bool) -> Cells:
    """Whole seconds and the rest apart, so that a microsecond is kept, and as the native half reads the same dates from a file."""
    unit = np.datetime_data(dates.dtype)[0]
    dates = dates if unit in ("s", "ms", "us", "ns") else dates.astype("datetime64[s]")
    a_second = {"s": 1, "ms": 10**3, "us": 10**6, "ns": 10**9}[np.datetime_data(dates.dtype)[0]]
    gone = np.isnat(dates)
    ticks = dates.astype(np.int64)
    there = ticks[~gone]
    seconds, rest = np.divmod(ticks, a_second)
    epoch = there[0] // a_second if len(there) else 0
    first = str(dates[~gone][0]) if len(there) else "its first row"
    first = first.rstrip("0").rstrip(".") if "." in first else first
    values = np.where(gone, np.nan, (seconds - epoch).astype(np.float64) + rest / a_second)
    return values, first + ("Z" if zoned else "")


def is_text(recording: Recording) -> bool:
    """Whether it is a path that the native half reads, and no file that holds a frame."""
    return isinstance(recording, (str, os.PathLike)) and not os.fspath(recording).lower().endswith(COLUMNAR)


def has_toml(recording: Recording) -> bool:
    """Whether it is a path whose TOML says what tables are told by ``columns``, ``units`` and ``drivers``."""
    if not is_text(recording):
        return False
    path = os.fspath(recording)  # type: ignore[arg-type]
    return path.lower().endswith(".toml") or os.path.isdir(path) or (path == EXAMPLE and not os.path.exists(path))


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
    table: FrameColumns = []
    left_out: dict[str, str] = {}
    clock: str | None = None
    if isinstance(recording, (str, os.PathLike)):
        is_told = bool(columns or units or drivers)
        if has_toml(recording) and is_told:
            raise TypeError("columns, units and drivers of this recording stand in its TOML; change them there, or give the table that it names: `a.csv`")
        if is_told and (reading or is_text(recording)):
            return os.fspath(recording), _says(os.fspath(recording), columns or {}, units or {}, drivers, base)
        if reading or is_text(recording):
            return recording
        name, table = os.fspath(recording), _truegap.read_columns(recording)
    else:
        table, left_out, clock = _table(recording)
    roles, measured = dict(columns or {}), dict(units or {})
    if clock is not None and "time" not in roles and not any(_is_clock(column) for column, *_ in table):
        roles["time"] = clock
    if not reading:
        table = _without_reading(table, roles.get("response"))
        roles["response"], measured["response"] = NO_READING, "1"
    wanted = [column for column in (*roles.values(), *(d.get("column", "") for d in (drivers or {}).values())) if column in left_out]
    if wanted:
        raise TypeError(f"the column `{wanted[0]}` of the frame {left_out[wanted[0]]}")
    clocks = [column for column in left_out if column.lower() in CLOCKS]
    if clocks and "time" not in roles and not any(_is_clock(column) for column, *_ in table):
        raise TypeError(f"the column `{clocks[0]}` of the frame is called after the clock and {left_out[clocks[0]]}; or drop it")
    return name, _says(name, roles, measured, drivers, base), table, list(left_out)


def _says(
    name: str,
    columns: Mapping[str, str],
    units: Mapping[str, str],
    drivers: Mapping[str, Mapping[str, str]] | None,
    base: Mapping[str, Any] | None,
) -> str:
    """What a recording's TOML would say."""
    says: dict[str, Any] = {"schema": "truegap.recording/1", "file": name, "columns": dict(columns), "units": dict(units)}
    says["drivers"] = {key: dict(value) for key, value in (drivers or {}).items()}
    if base is not None:
        says["base"] = dict(base)
    return json.dumps(says)


def _is_clock(column: str) -> bool:
    """Whether a column is taken for the clock by its name alone."""
    return column.lower() in CLOCKS or column.lower().startswith("time")


def _table(recording: Any) -> tuple[FrameColumns, dict[str, str], str | None]:
    """Columns of numbers and times, what is wrong with the others, and the clock where that is the index of the frame."""
    collect = getattr(recording, "collect", None)
    if type(recording).__name__ == "LazyFrame" and callable(collect):
        recording = collect()
    _refuse_rows(recording)
    table: FrameColumns = []
    left_out: dict[str, str] = {}
    index, clock = _index(recording)
    found = names(recording)
    columns = [*((name, (cells, False)) for name, cells in index.items()), *((name, _column(recording, name)) for name in found)]
    for name, (column, zoned) in columns:
        if found.count(name) > 1:
            left_out[name] = "is there twice; rename one, or drop it"
            continue
        cells = numeric(column, zoned) or _dates(name, column, left_out)
        if cells is not None and cells[0].ndim == 1:
            table.append((name, *cells))
        elif name not in left_out:
            left_out[name] = _not_numbers(name, column)
    return table, left_out, clock


def _refuse_rows(recording: Any) -> None:
    """Refuse a dict that holds one row, and one whose columns differ in length."""
    if not isinstance(recording, Mapping) or not recording:
        return
    if all(np.ndim(cells) == 0 for cells in recording.values()):
        raise TypeError("the dict holds single values and no columns; make a frame of a list of rows: pandas.DataFrame(rows)")
    lengths = {str(name): len(cells) for name, cells in recording.items() if np.ndim(cells) > 0}
    first = next(iter(lengths))
    for name, length in lengths.items():
        if length != lengths[first]:
            raise ValueError(f"the column `{name}` has {length} rows and `{first}` has {lengths[first]}; give every column one value a row")


def _index(frame: Any) -> tuple[dict[str, Any], str | None]:
    """The index of a pandas frame as columns where it has a name or is a clock, and the name of the clock."""
    index: Any = getattr(frame, "index", None)
    if not hasattr(index, "get_level_values") or not hasattr(frame, "columns"):
        return {}, None
    found: dict[str, Any] = {}
    clock = None
    clocked = any(_is_clock(name) for name in names(frame))
    for level, given in enumerate(index.names):
        values = index.get_level_values(level)
        is_clock = getattr(values.dtype, "kind", "O") in "mM"
        name = str(given) if given is not None else "time" if is_clock and not clocked else None
        if name is None or name in names(frame):
            continue
        zoned = getattr(values.dtype, "tz", None) is not None
        # a clock with a zone is told in Greenwich, as that of a column is
        found[name] = values.tz_convert("UTC").to_pydatetime() if zoned else values.to_numpy()
        clock = name if is_clock and clock is None else clock
    return found, clock


def _texts(column: Any) -> list[str | None] | None:
    """The cells where all of them are texts or holes."""
    cells = [None if cell is None or cell != cell else cell for cell in np.asarray(column, dtype=object).ravel()]
    return cells if all(cell is None or isinstance(cell, str) for cell in cells) else None


def _dates(name: str, column: Any, left_out: dict[str, str]) -> Cells | None:
    """Dates that stand there as text; what is wrong with them goes into ``left_out``, and matters where the column does."""
    texts = _texts(column)
    if texts is None:
        return None
    try:
        return _truegap.read_dates(name, texts)
    except _truegap.TruegapError as error:
        left_out[name] = f"cannot be a clock: {error}"
        return None


def _not_numbers(name: str, column: Any) -> str:
    """What a column holds instead of numbers, and how to make numbers of it."""
    cells = np.asarray(column, dtype=object)
    if cells.ndim != 1:
        return f"has {cells.ndim} dimensions; give one value a row"
    for row, cell in enumerate(cells, start=1):
        if cell is None or cell != cell or _is_number(cell):
            continue
        remedy = f"frame[{name!r}] = pandas.to_numeric(frame[{name!r}], errors='coerce') makes holes of what is no number"
        if isinstance(cell, str) and _is_number(cell.replace(",", ".", 1)):
            remedy = f"frame[{name!r}] = frame[{name!r}].str.replace(',', '.').astype(float) makes points of decimal commas"
        return f"holds neither numbers nor dates: {str(cell)!r} in row {row}; {remedy}"
    return "holds neither numbers nor dates; give numbers"


def _is_number(cell: Any) -> bool:
    try:
        float(cell)
    except (TypeError, ValueError):
        return False
    return True


def _column(frame: Any, name: str) -> tuple[Any, bool]:
    """The column as an array, and whether its dates have a zone; those of Greenwich then."""
    try:
        column = frame[name]
    except KeyError:  # a name that is a number
        column = frame[next(found for found in frame.columns if str(found) == name)]
    kind = getattr(column, "dtype", None)
    if getattr(kind, "tz", None) is not None:
        return column.to_numpy(dtype="datetime64[ns]"), True
    zoned = bool(getattr(kind, "time_zone", None) or getattr(getattr(column, "type", None), "tz", None))
    return (column.to_numpy() if hasattr(column, "to_numpy") else column), zoned


def _without_reading(table: FrameColumns, response: str | None) -> FrameColumns:
    rows = len(table[0][1]) if table else 0
    kept = [column for column in table if column[0] != response]
    return [*kept, (NO_READING, np.zeros(rows), None)]


def list_of(recordings: Recording | Sequence[Recording]) -> list[Recording]:
    """One recording or several, as a list."""
    if isinstance(recordings, (list, tuple)):
        return list(recordings)
    return [recordings]
