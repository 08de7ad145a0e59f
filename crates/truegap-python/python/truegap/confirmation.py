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

    @property
    def rivals(self) -> dict[tuple[str, str], float]:
        """Errors, in ``unit``, of the models with a rival in the place of a named effect, by ``(rival, named effect)``; empty where the diagnosis left none open."""
        judged = self.document.get("rivals", {}).get("judged", [])
        return {(rival["id"], rival["instead_of"]): float(rival["rmse"]) for rival in judged}

    @property
    def rivals_say(self) -> str:
        """What this recording says of what the diagnosis could not tell apart; an empty text where it left nothing open."""
        return str(self.document.get("rivals", {}).get("says", ""))

    def __repr__(self) -> str:
        return f"<truegap.Confirmation: {' '.join(filter(None, [f'{self.verdict}. {self.says}', self.rivals_say]))}>"

    def _repr_html_(self) -> str:
        rivals = [(f"{rival} for {named}".replace("_", " "), rmse) for (rival, named), rmse in self.rivals.items()]
        rows = [("base model alone", self.rmse_base), ("augmented model", self.rmse_augmented), *rivals, ("noise", self.noise)]
        cells = "".join(f"<tr><td>{name}</td><td>{value:.4g} {escape(self.unit)}</td></tr>" for name, value in rows)
        return f"<p><b>{escape(self.verdict)}</b>. {escape(self.says)}</p><table>{cells}</table><p>{escape(self.rivals_say)}</p>"
