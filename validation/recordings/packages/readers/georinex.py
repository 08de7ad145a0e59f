"""Reads files of the package georinex: what a receiver of navigation satellites noted, in the format RINEX 3."""

import numpy as np
from formats.clock import since_first
from formats.packed import unpacked

LABEL, WIDTH, FIGURES = 60, 16, 14


def codes(head, system):
    """Codes of what is noted of the satellites of a system, a letter, in their order; a list goes on in lines that begin with a blank."""
    found, at = [], ""
    for text in head:
        if text[LABEL:].startswith("SYS / # / OBS TYPES"):
            at = text[0].strip() or at
            found += text[7:LABEL].split() if at == system else []
    return found


def numbers(text, many):
    """Numbers of a satellite's row; one that is missing is nan."""
    cells = [text[3 + WIDTH * k :][:FIGURES].strip() for k in range(many)]
    return [float(cell) if cell else np.nan for cell in cells]


def observed(content, satellite, *wanted):
    """What was noted of a satellite on one day: seconds since the first row, and columns by their codes, rows in which none of these is missing."""
    lines = unpacked(content).decode().splitlines()
    end = next(k for k, text in enumerate(lines) if text[LABEL:].startswith("END OF HEADER"))
    known, rows, now = codes(lines[:end], satellite[0]), [], 0.0
    for text in lines[end + 1 :]:
        if text.startswith(">"):
            hour, minute, second = map(float, text.split()[4:7])
            now = hour * 3600 + minute * 60 + second
        elif text.startswith(satellite):
            rows.append([now, *numbers(text, len(known))])
    kept = np.array(rows)[:, [0, *(1 + known.index(code) for code in wanted)]]
    kept = kept[np.isfinite(kept).all(axis=1)]
    return {"time_s": since_first(kept[:, 0]), **dict(zip(wanted, kept[:, 1:].T))}
