"""Finite-element cases and design studies: what the command line answers, as a dict, and its files in ``folder`` where one is given."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Union

from . import _truegap
from .analytic import DEFAULT_SENSOR
from .answer import Document, read
from .frames import Path
from .progress import ProgressLike, watching

Sensors = Union[str, Sequence[str]]
#: What a metric may be: least and greatest value, ``None`` where there is no such end.
Limit = tuple[Union[float, None], Union[float, None]]


def solve(case: Path) -> Document:
    """The quantities of a finite-element case (TOML) with error estimates, as ``truegap --json solve`` prints them."""
    return read(_truegap.solve(case))


def sensitivity(
    sensor: Sensors = DEFAULT_SENSOR,
    *,
    change_pct: float = 10.0,
    rows: int = 4096,
    seed: int = 1,
    folder: Path | None = None,
    progress: ProgressLike = None,
) -> Document:
    """Which quantity moves which number of the data sheet: one at a time, derivatives, Sobol indices over the tolerances."""
    if not 0.0 < change_pct < 100.0:
        raise ValueError(f"change_pct is {change_pct}: give a number of per cent above 0 and below 100")
    with watching(progress) as watch:
        return read(_truegap.sensitivity(_names(sensor), change_pct, rows, seed, folder, watch))


def tolerance(
    sensor: Sensors = DEFAULT_SENSOR,
    *,
    limits: Mapping[str, Limit] | None = None,
    samples: int = 1_000_000,
    seed: int = 1,
    folder: Path | None = None,
    progress: ProgressLike = None,
) -> Document:
    """Scatter and yield of a batch within its tolerances, and which tolerance to tighten first: ``limits={"span": (2.3, 2.6)}``."""
    each = [(metric, low, high) for metric, (low, high) in (limits or {}).items()]
    with watching(progress) as watch:
        return read(_truegap.tolerance(_names(sensor), each, samples, seed, folder, watch))


def optimise(
    sensor: str = DEFAULT_SENSOR,
    *,
    vary: Mapping[str, str] | None = None,
    hold: Sequence[str] = (),
    least_baseline: float | None = None,
    least_span: float | None = None,
    most_linearity: float | None = None,
    most_covered: float | None = None,
    searches: int = 4,
    seed: int = 1,
    folder: Path | None = None,
    progress: ProgressLike = None,
) -> Document:
    """Designs with smaller temperature coefficients: ``vary={"height": "150 um:210 um", "conductor": "10 um,17 um"}`` in place of the paper's ranges."""
    if searches < 1:
        raise ValueError(f"searches is {searches}: there is nothing to search with; give 1 or more")
    ranges = [f"{quantity}={values}" for quantity, values in (vary or {}).items()]
    useful = (least_baseline, least_span, most_linearity, most_covered)
    with watching(progress) as watch:
        return read(_truegap.optimise(sensor, ranges, list(hold), useful, searches, seed, folder, watch))


def _names(sensor: Sensors) -> list[str]:
    return [sensor] if isinstance(sensor, str) else list(sensor)
