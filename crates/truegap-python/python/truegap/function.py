"""A user's simulator ``f(inputs, parameters) -> array`` as the native half calls it."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

import numpy as np

from .parameter import Named, Parameter
from .tables import Column

#: ``inputs`` holds one array a recorded column, in SI: ``run``, ``time_s``, ``force_n``, ``pressure_pa``, ``gap_m``, ``temperature_c``, ``humidity_pct``,
#: ``simulated``, and every driver under its own name.
Simulator = Callable[[dict[str, Column], dict[str, float]], Any]
Given = tuple[str, Callable[[dict[str, Column], dict[str, float]], Column], list[Named]]


def given(simulator: Simulator, parameters: Mapping[str, Parameter] | None) -> Given:
    """The simulator with its name and parameters; what it answers is checked where it can be blamed."""
    name = getattr(simulator, "__name__", type(simulator).__name__)

    def answer(inputs: dict[str, Column], values: dict[str, float]) -> Column:
        answered = np.asarray(simulator(inputs, values))
        rows = inputs["run"].shape
        if answered.dtype.kind == "O" and answered.ndim == 0 and answered.item() is None:
            raise TypeError(f"`{name}` answered with None for {rows[0]} rows; end it with `return` and one number a row")
        if answered.dtype.kind == "c":
            raise TypeError(f"`{name}` answered with complex numbers; return a real one a row, as abs(...) or (...).real")
        try:
            response = answered.astype(np.float64, copy=False)
        except (TypeError, ValueError) as error:
            raise ValueError(f"`{name}` answered with something that is no number ({error}); return one number a row") from error
        if response.shape != rows:
            raise ValueError(f"`{name}` answered with an array of shape {response.shape} for {rows[0]} rows; return one number a row")
        return response

    return name, answer, [Named.of(key, value) for key, value in (parameters or {}).items()]
