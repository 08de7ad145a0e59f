"""Readings of a sensor without the physics that was added to its model."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
import numpy.typing as npt

from .tables import frame_of


@dataclass(frozen=True)
class Compensation:
    """Corrected readings, one a row, and how far they can be trusted; stands for the readings where an array is wanted."""

    #: the whole answer, as ``truegap --json compensate`` prints it
    document: dict[str, Any]
    #: rows with reading, corrected reading and estimated input
    table: dict[str, npt.NDArray[np.float64]]

    @property
    def corrected(self) -> npt.NDArray[np.float64]:
        """Readings without the added physics, in ``unit``."""
        return self.table["corrected"]

    @property
    def says(self) -> str:
        return str(self.document["says"])

    @property
    def unit(self) -> str:
        return str(self.document["unit"])

    @property
    def passes(self) -> int:
        return int(self.document["passes"])

    @property
    def noise_growth(self) -> float:
        """Noise of a corrected reading over that of a reading."""
        return float(self.document["noise_growth"])

    @property
    def notes(self) -> list[str]:
        """What a reader should know: effects left out, rows without an answer."""
        return [str(note) for note in self.document["notes"]]

    def to_frame(self) -> Any:
        """The rows as a pandas frame, else a polars one; a dict of arrays where neither is installed."""
        return frame_of(self.table)

    def __array__(self, dtype: Any = None, copy: bool | None = None) -> npt.NDArray[Any]:
        return np.array(self.corrected, dtype=dtype) if copy else np.asarray(self.corrected, dtype=dtype)

    def __len__(self) -> int:
        return len(self.corrected)

    def __repr__(self) -> str:
        return f"<truegap.Compensation: {self.says}>"
