"""One figure: recording and models, and what each leaves over."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from .diagnosis import Diagnosis
    from .tables import Column

#: Colours that a colour-blind reader tells apart (Okabe & Ito 2008).
RECORDED, BASE, AUGMENTED = "#000000", "#0072B2", "#D55E00"


def figure(d: Diagnosis) -> Figure:
    """The figure; ``savefig`` writes it as SVG or PDF."""
    import matplotlib.pyplot as plt

    table = d.table
    recorded, base = _ending("recorded", table), _ending("base", table)
    augmented = _ending("augmented", table) if d.findings else None
    x, label, breaks = _axis(table)
    x = _broken(x, breaks)
    shown, (above, below) = plt.subplots(2, 1, sharex=True, figsize=(7, 5), layout="constrained", height_ratios=(3, 2))
    above.plot(x, _broken(recorded, breaks), color=RECORDED, lw=0.8, label="recorded")
    above.plot(x, _broken(base, breaks), color=BASE, lw=1.2, label="simulation, calibrated")
    below.axhspan(-d.noise, d.noise, color="0.85", lw=0, label="noise (1 sd)")
    below.plot(x, _broken(recorded - base, breaks), color=BASE, lw=0.8)
    if augmented is not None:
        name = " and ".join(f.effect.replace("_", " ") for f in d.findings)
        above.plot(x, _broken(augmented, breaks), color=AUGMENTED, lw=1.2, ls="--", label=f"with {name}")
        below.plot(x, _broken(recorded - augmented, breaks), color=AUGMENTED, lw=0.8)
    above.set_ylabel(f"response [{d.unit}]")
    below.set_ylabel(f"left over [{d.unit}]")
    below.set_xlabel(label)
    # outside, where no curve is hidden by it
    shown.legend(loc="outside lower left", ncols=2, frameon=False, fontsize="small")
    above.set_title(d.verdict.replace("_", " "), loc="left")
    return shown


def _ending(name: str, table: dict[str, Column]) -> Column:
    """The column `base_pf` of `base`: its unit stands behind the name."""
    return next(column for key, column in table.items() if key.rsplit("_", 1)[0] == name)


def _axis(table: dict[str, Column]) -> tuple[Column, str, Any]:
    """Time where it was recorded, else rows; and where a run ends."""
    number = table.get("recording", np.zeros_like(table["run"]))
    breaks = np.flatnonzero((np.diff(table["run"]) != 0) | (np.diff(number) != 0)) + 1
    if "time_s" in table and not np.any(np.diff(number)):
        return table["time_s"], "time [s]", breaks
    return np.arange(len(table["run"]), dtype=np.float64), "row", breaks


def _broken(column: Column, breaks: Any) -> Any:
    """The column with a hole between two runs, so that no line joins them."""
    return np.insert(column.astype(np.float64), breaks, np.nan)
