"""The first screen of a report, for a notebook: the sentence, what was found, the errors."""

from __future__ import annotations

from html import escape
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from .diagnosis import Diagnosis

#: A line at the side, so that light and dark notebooks both show it.
STYLE = "border-left:4px solid #3b7dd8;padding-left:1em"


def first_screen(d: Diagnosis) -> str:
    parts = [f"<h3>{escape(d.verdict.replace('_', ' '))}</h3>", f"<p>{escape(d.says)}</p>"]
    if d.findings:
        rows = [(f.effect.replace("_", " "), f"{f.probability:.3f}", "; ".join(map(str, f.parameters))) for f in d.findings]
        parts.append(_table(("missing", "probability", "size"), rows))
    if d.ambiguity:
        sets = "; ".join(" or ".join(name.replace("_", " ") for name in names) for names in d.ambiguity)
        parts.append(f"<p>Cannot be told apart: {escape(sets)}.</p>")
    parts.append(_errors(d))
    if d.next_experiment:
        parts.append(f"<p>Next: {escape(d.next_experiment)}</p>")
    return f'<div style="{STYLE}">{"".join(parts)}</div>'


def _errors(d: Diagnosis) -> str:
    fit = d.document["fit"]

    def error(value: float | None) -> str:
        return "-" if value is None else f"{value:.4g} {d.unit}"

    rows = [
        ("in sample", error(fit["in_sample"]["rmse_before"]), error(fit["in_sample"]["rmse_after"])),
        ("rows left out", error(fit["held_out"]["rmse_before"]), error(fit["held_out"]["rmse_after"])),
        ("noise", error(fit["noise_floor"]), error(fit["noise_floor"])),
    ]
    return _table(("error (RMS)", "simulation", "with what was missing"), rows)


def _table(header: tuple[str, ...], rows: list[Any]) -> str:
    head = "".join(f"<th>{escape(cell)}</th>" for cell in header)
    body = "".join("<tr>" + "".join(f"<td>{escape(cell)}</td>" for cell in row) + "</tr>" for row in rows)
    return f"<table><thead><tr>{head}</tr></thead><tbody>{body}</tbody></table>"
