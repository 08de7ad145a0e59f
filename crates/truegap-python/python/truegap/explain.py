"""What an effect is, in the library's own words."""

from __future__ import annotations

from dataclasses import dataclass
from html import escape

from . import _truegap
from .answer import Document, read


@dataclass(frozen=True)
class Explained:
    """Physics, equation, what shows it, its rivals and what tells it from them."""

    effect: str
    physics: str
    equation: str
    #: what a recording must contain
    needs: str
    mistaken_for: tuple[str, ...]
    told_apart_by: str
    source: str
    #: all of it, as ``truegap --json explain`` prints it
    document: Document

    def __str__(self) -> str:
        return "\n".join([f"{self.effect}: {self.physics}.", "", f"    {self.equation}", "", *(f"{name}: {text}" for name, text in self._lines())])

    def _repr_html_(self) -> str:
        rows = "".join(f"<tr><th>{name}</th><td>{escape(text)}</td></tr>" for name, text in self._lines())
        return f"<p><b>{escape(self.effect)}</b>: {escape(self.physics)}.</p><pre>{escape(self.equation)}</pre><table>{rows}</table>"

    def _lines(self) -> list[tuple[str, str]]:
        numbers = "; ".join(f"{p['name']} [{p['unit']}]: {p['meaning']}" for p in self.document["parameters"])
        rivals = ", ".join(self.mistaken_for)
        return [
            ("needs", self.needs),
            ("mistaken for", rivals),
            ("told apart by", self.told_apart_by),
            ("fitted", numbers),
            ("source", self.source),
        ]


def explain(effect: str) -> Explained:
    """The effect of this name, as a finding has it: ``tg.explain("thermal_lag")``."""
    raw = read(_truegap.explain(effect))
    return Explained(
        raw["effect"],
        raw["physics"],
        raw["equation"],
        raw["needs"],
        tuple(raw["mistaken_for"]),
        raw["told_apart_by"],
        raw["source"],
        raw,
    )


def effects() -> dict[str, str]:
    """Every effect of the library with its physics in a sentence."""
    return dict(read(_truegap.explain(None)))
