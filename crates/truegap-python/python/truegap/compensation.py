"""Readings of a sensor without the physics that was added to its model."""

from __future__ import annotations

from dataclasses import dataclass

from .answer import Answer, StandsForColumn
from .tables import Column


@dataclass(frozen=True)
class Compensation(StandsForColumn, Answer):
    """Corrected readings, one a row, and how far they can be trusted; stands for the readings where an array is wanted.

    ``document`` is what ``truegap --json compensate`` prints, ``table`` the rows with reading, corrected reading and estimated input.
    """

    @property
    def corrected(self) -> Column:
        """Readings without the added physics, in ``unit``."""
        return self.table["corrected"]

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

    def _column(self) -> Column:
        return self.corrected

    def __repr__(self) -> str:
        return f"<truegap.Compensation: {self.says}>"
