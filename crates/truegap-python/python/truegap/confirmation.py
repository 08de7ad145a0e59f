"""What another recording says of the physics that was added."""

from __future__ import annotations

from dataclasses import dataclass
from html import escape
from typing import Any

import numpy as np
import numpy.typing as npt

from .tables import frame_of


@dataclass(frozen=True)
class Confirmation:
    """``confirmed``, ``refuted`` or ``cannot_tell``, and what it rests on."""

    #: the whole answer, as ``confirmation.json`` holds it
    document: dict[str, Any]
    #: rows with both predictions, as ``confirmation.csv`` holds them
    table: dict[str, npt.NDArray[np.float64]]

    @property
    def verdict(self) -> str:
        return str(self.document["verdict"])

    @property
    def says(self) -> str:
        return str(self.document["says"])

    @property
    def unit(self) -> str:
        return str(self.document["unit"])

    @property
    def rmse_base(self) -> float:
        """Error of the base model alone, in ``unit``."""
        return float(self.document["base"]["rmse"])

    @property
    def rmse_augmented(self) -> float:
        """Error of the augmented model, in ``unit``."""
        return float(self.document["augmented"]["rmse"])

    @property
    def noise(self) -> float:
        """Noise of the recording, in ``unit``."""
        return float(self.document["noise"]["rmse"])

    def to_frame(self) -> Any:
        """The rows as a pandas frame, else a polars one; a dict of arrays where neither is installed."""
        return frame_of(self.table)

    def __repr__(self) -> str:
        return f"<truegap.Confirmation: {self.verdict}. {self.says}>"

    def _repr_html_(self) -> str:
        rows = [("base model alone", self.rmse_base), ("augmented model", self.rmse_augmented), ("noise", self.noise)]
        cells = "".join(f"<tr><td>{name}</td><td>{value:.4g} {escape(self.unit)}</td></tr>" for name, value in rows)
        return f"<p><b>{escape(self.verdict)}</b>. {escape(self.says)}</p><table>{cells}</table>"
