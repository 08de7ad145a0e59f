"""What another recording says of the physics that was added."""

from __future__ import annotations

from dataclasses import dataclass
from html import escape

from .answer import Answer


@dataclass(frozen=True)
class Confirmation(Answer):
    """``confirmed``, ``refuted`` or ``cannot_tell``, and what it rests on: ``document`` as in ``confirmation.json``, ``table`` as in ``confirmation.csv``."""

    @property
    def verdict(self) -> str:
        return str(self.document["verdict"])

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

    def __repr__(self) -> str:
        return f"<truegap.Confirmation: {self.verdict}. {self.says}>"

    def _repr_html_(self) -> str:
        rows = [("base model alone", self.rmse_base), ("augmented model", self.rmse_augmented), ("noise", self.noise)]
        cells = "".join(f"<tr><td>{name}</td><td>{value:.4g} {escape(self.unit)}</td></tr>" for name, value in rows)
        return f"<p><b>{escape(self.verdict)}</b>. {escape(self.says)}</p><table>{cells}</table>"
