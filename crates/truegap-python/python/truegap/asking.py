"""``diagnose`` and ``confirm``."""

from __future__ import annotations

import json
import os
import shlex
from collections.abc import Mapping, Sequence
from typing import Any, Union

from . import _truegap
from .confirmation import Confirmation
from .diagnosis import Diagnosis
from .frames import Path, Recording, is_text, list_of, source
from .function import Simulator, given
from .parameter import Parameter
from .progress import ProgressLike, watching

Base = Union[str, Mapping[str, Any], Simulator, None]


def diagnose(
    recordings: Recording | Sequence[Recording],
    *,
    base: Base = None,
    parameters: Mapping[str, Parameter] | None = None,
    sensor: str | None = None,
    columns: Mapping[str, str] | None = None,
    units: Mapping[str, str] | None = None,
    drivers: Mapping[str, Mapping[str, str]] | None = None,
    warp: bool = True,
    effects: Sequence[str] = (),
    conceal: Sequence[str] = (),
    channel: str | None = None,
    free: Sequence[str] = (),
    bank: int | None = None,
    effect_files: Sequence[Path] = (),
    library_only: bool = False,
    select_in_folds: bool = False,
    permuted_searches: int | None = None,
    cache: bool | Path = False,
    progress: ProgressLike = None,
) -> Diagnosis:
    """Say what physics a simulation leaves out of a recording.

    ``recordings``: a path (TOML, CSV, folder, or ``"example"``), a pandas or polars frame, a dict of arrays, or a list of these, diagnosed together.
    ``base``: the simulation. A function ``f(inputs, parameters) -> array`` with its ``parameters``; a name as in a recording's TOML (``"linear"``,
    ``"parallel-plate"``, ...); or a dict of what would stand under ``[base]``. With a path it may be left out: the TOML names it.
    ``columns``, ``units``, ``drivers``: of a frame or a table, as in a TOML: ``columns={"force": "Load cell"}, units={"force": "N"}``.
    ``cache``: a folder in which the answers of a slow program (``{"model": "command", ...}``) are kept for the next diagnosis, or ``True`` for that of the command line.
    ``progress``: a function ``f(done, step, what)``, ``True`` for a bar, ``False`` for none; a bar on a terminal or in a notebook where nothing is said.

    The remaining words are those of ``truegap diagnose``; ``effect_files`` are those of its ``--effect``. Raises ``TruegapError``; an exception of the simulator comes back as it is, with a note of the
    parameters that it was called with.
    """
    each = list_of(recordings)
    function = given(base, parameters) if callable(base) else None
    if function is None and parameters:
        raise TypeError("parameters belong to a base that is a function; a program declares its own in the TOML, under [base.parameters]")
    if function is not None and cache is not False:
        raise TypeError("answers of a function are not kept, as nobody can tell whether it has changed; keep them in the function, or make it a program")
    table = base if isinstance(base, Mapping) else None
    name = "function" if function else base if isinstance(base, str) else None
    framed = {"columns": columns, "units": units, "drivers": drivers, "base": table}
    sources = [source(r, name=_name(i, each), **framed) for i, r in enumerate(each)]  # type: ignore[arg-type]
    asked: dict[str, Any] = {
        "sensor": sensor,
        "base": name,
        "no_warp": not warp,
        "effects": list(effects),
        "conceal": list(conceal),
        "channel": channel,
        "free": list(free),
        "bank": bank,
        "effect_files": [os.fspath(file) for file in effect_files],
        "library_only": library_only,
        "select_in_folds": select_in_folds,
        "permuted_searches": permuted_searches,
        "cache": None if isinstance(cache, bool) else os.fspath(cache),
        "remember": cache is True,
    }
    asked["command"] = _command(each, base, asked, _maps(columns or {}, units or {}, drivers or {}))
    with watching(progress) as watch:
        native = _truegap.diagnose(sources, json.dumps(asked), None if table is None else json.dumps(table), function, watch)
    return Diagnosis(native, columns, units, drivers)


def confirm(
    model: Path,
    recording: Recording,
    *,
    base: Simulator | None = None,
    parameters: Mapping[str, Parameter] | None = None,
    columns: Mapping[str, str] | None = None,
    units: Mapping[str, str] | None = None,
    drivers: Mapping[str, Mapping[str, str]] | None = None,
    free: Sequence[str] = (),
    channel: str | None = None,
) -> Confirmation:
    """Judge the ``augmented.toml`` of a diagnosis on a recording that took no part in it; nothing is refitted but ``free``: gain, offset, clock.

    Where the base model was a function, ``base`` and ``parameters`` give it again.
    """
    function = given(base, parameters) if base is not None else None
    other = source(recording, name="frame", columns=columns, units=units, drivers=drivers, base=None)
    return Confirmation.of(_truegap.confirm(model, other, list(free), channel, function))


def _name(index: int, recordings: Sequence[Recording]) -> str:
    return "frame" if len(recordings) == 1 else f"frame {index + 1}"


def _maps(columns: Mapping[str, str], units: Mapping[str, str], drivers: Mapping[str, Mapping[str, str]]) -> list[str] | None:
    """What ``--map`` says of the columns; ``None`` where it cannot, as a unit stands there without its column."""
    if any(role not in columns for role in units):
        return None
    named = [(role, column, units.get(role)) for role, column in columns.items()]
    named += [(f"driver.{name}", driver.get("column", ""), driver.get("unit")) for name, driver in drivers.items()]
    return [f"{what}={column}" + (f":{unit}" if unit else "") for what, column, unit in named]


def _command(recordings: Sequence[Recording], base: Base, asked: Mapping[str, Any], maps: Sequence[str] | None) -> str:
    """The command line that does the same, where there is one; for the record."""
    if not all(is_text(r) for r in recordings) or callable(base) or isinstance(base, Mapping) or maps is None:
        function = f", base={getattr(base, '__name__', 'simulator')}" if callable(base) else ""
        return f"truegap.diagnose(...{function})"
    words = ["truegap", "diagnose", *(str(r) for r in recordings)]
    for key in ("sensor", "base", "channel", "bank", "permuted_searches"):
        words += [f"--{key.replace('_', '-')}", str(asked[key])] if asked[key] is not None else []
    for key in ("effects", "conceal", "free"):
        words += [f"--{key}", ",".join(asked[key])] if asked[key] else []
    for text in maps:
        words += ["--map", text]
    for file in asked["effect_files"]:
        words += ["--effect", file]
    words += [f"--{key.replace('_', '-')}" for key in ("no_warp", "library_only", "select_in_folds") if asked[key]]
    return shlex.join(words).replace("'", '"')
