"""Columns, and a frame of them of whichever library is there."""

from __future__ import annotations

import importlib
from collections.abc import Mapping
from typing import Any

import numpy as np
import numpy.typing as npt

Column = npt.NDArray[np.float64]


def frame_of(columns: Mapping[str, Any]) -> Any:
    """A pandas frame, else a polars one; a dict of arrays where neither is installed."""
    for library in ("pandas", "polars"):
        try:
            return importlib.import_module(library).DataFrame(dict(columns))
        except ImportError:
            continue
    return dict(columns)
