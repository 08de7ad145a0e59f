"""Recordings and simulators that the tests share; every truth is known because it is made here."""

from __future__ import annotations

import os
import shutil
import sys
from pathlib import Path
from typing import Any

import matplotlib
import numpy as np
import pytest

matplotlib.use("Agg")
EXAMPLES = Path(__file__).parent.parent / "examples"
sys.path.insert(0, str(EXAMPLES))
ROOT = Path(__file__).parents[3]


def command() -> str:
    """The command `truegap`, which the package is compared with."""
    found = os.environ.get("TRUEGAP_COMMAND") or shutil.which("truegap")
    assert found is not None, "set TRUEGAP_COMMAND to the path of the command `truegap`"
    return found


def spring(inputs: dict[str, Any], parameters: dict[str, float]) -> Any:
    return parameters["rest"] + inputs["force_n"] / parameters["k"]


def pressed(seed: int = 1, rows: int = 300) -> dict[str, Any]:
    """2 N/mm, 1 mm at rest, 5 um of noise: nothing is missing."""
    time = np.arange(rows, dtype=float)
    force = 5 + 5 * np.sin(time / 11)
    return {"time_s": time, "force_n": force, "response_mm": 1 + force / 2 + np.random.default_rng(seed).normal(0, 5e-3, rows)}


@pytest.fixture
def parameters() -> dict[str, Any]:
    import truegap as tg

    return {"k": tg.Parameter(1.8, sd=0.5, unit="N/mm", low=0.1), "rest": tg.Parameter(0.0, sd=3.0, unit="mm")}
