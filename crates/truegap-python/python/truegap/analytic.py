"""The analytic model of a capacitive sensor, its coefficients, and the audit of its assumptions."""

from __future__ import annotations

import json
from collections.abc import Sequence
from typing import Any

import numpy as np
import numpy.typing as npt

from . import _truegap
from .answer import Document, read
from .frames import Path
from .tables import frame_of

DEFAULT_SENSOR = "singletact-s15-4.5n"


def _list(values: float | Sequence[float] | npt.NDArray[np.float64]) -> list[float]:
    return [float(value) for value in np.atleast_1d(np.asarray(values, dtype=np.float64))]


def simulate(
    sensor: str = DEFAULT_SENSOR,
    *,
    force_n: float | Sequence[float] | npt.NDArray[np.float64],
    temperature_c: float | Sequence[float] | npt.NDArray[np.float64] | None = None,
    warp: bool = True,
) -> Any:
    """Capacitances (pF), strain and curvature at every force at the first temperature, then at the next; a frame."""
    temperatures = None if temperature_c is None else _list(temperature_c)
    states = json.loads(_truegap.simulate(sensor, _list(force_n), temperatures, warp))
    return frame_of({name: np.array([state[name] for state in states], dtype=np.float64) for name in states[0]})


def coefficients(sensor: str = DEFAULT_SENSOR, *, warp: bool = True) -> Document:
    """Temperature coefficients and linearity between 20 and 50 degC; names hold the units."""
    return read(_truegap.coefficients(sensor, warp))


def audit(
    sensor: str = DEFAULT_SENSOR, *, only: Sequence[str] = (), remember: bool = True, folder: Path | None = None
) -> Document:
    """Every assumption of the analytic model measured by finite elements: the content of ``audit.json``, which is also written to ``folder``."""
    return read(_truegap.audit(sensor, list(only), remember, folder))


def sensors() -> list[str]:
    """Names of the built-in sensors."""
    return _truegap.sensors()
