"""A bar on a terminal or in a notebook, or a function of the user's own."""

from __future__ import annotations

import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any, Union

Progress = Callable[[float, str, str], object]
ProgressLike = Union[Progress, bool, None]

#: Seconds between two drawings.
REDRAW = 0.1


@contextmanager
def watching(progress: ProgressLike) -> Iterator[Progress | None]:
    """What to call with every step, and what to clear away at the end."""
    if callable(progress):
        yield progress
        return
    display = _notebook()
    if progress is False or (progress is None and display is None and not sys.stderr.isatty()):
        yield None
        return
    bar = Bar(display)
    try:
        yield bar
    finally:
        bar.clear()


class Bar:
    """Share done, and what is being done; drawn at most ten times a second."""

    def __init__(self, display: Any = None) -> None:
        self.display, self.width, self.drawn, self.share = display, 0, 0.0, 0.0

    def __call__(self, done: float, step: str, what: str) -> None:
        # the share of a later step may begin lower: a bar does not go back
        self.share = max(self.share, done)
        now = time.monotonic()
        if now - self.drawn < REDRAW:
            return
        self.drawn = now
        full = round(24 * min(max(self.share, 0.0), 1.0))
        self.draw(f"{'█' * full}{'·' * (24 - full)} {100 * self.share:3.0f} %  {step}: {what}"[:100])

    def draw(self, text: str) -> None:
        if self.display is not None:
            self.display.update({"text/plain": text}, raw=True)
            return
        sys.stderr.write("\r" + text.ljust(self.width))
        sys.stderr.flush()
        self.width = len(text)

    def clear(self) -> None:
        self.draw("")
        if self.display is None:
            sys.stderr.write("\r")


def _notebook() -> Any:
    """A place to draw in, where this is a notebook."""
    shell = sys.modules.get("IPython")
    running = shell.get_ipython() if shell is not None else None
    if running is None or not hasattr(running, "kernel"):
        return None
    from IPython.display import display

    return display({"text/plain": ""}, raw=True, display_id=True)
