"""Columns as a frame of whichever library is there."""

from __future__ import annotations

import importlib
from collections.abc import Mapping
from typing import Any


def frame_of(columns: Mapping[str, Any]) -> Any:
    """A pandas frame, else a polars one; a dict of arrays where neither is installed."""
    for library in ("pandas", "polars"):
        try:
            return importlib.import_module(library).DataFrame(dict(columns))
        except ImportError:
            continue
    return dict(columns)
