"""What the answers of the native half share: a document and a table, and an array that an answer stands for."""

from __future__ import annotations

import json
from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any, TypeVar, cast

import numpy as np
import numpy.typing as npt

from .tables import Column, frame_of

#: An answer as the command line prints it.
Document = dict[str, Any]

Kind = TypeVar("Kind", bound="Answer")


def read(text: str) -> Document:
    """A document out of the text of the native half."""
    return cast(Document, json.loads(text))


@dataclass(frozen=True)
class Answer:
    """A document with its sentence, and the rows behind it."""

    #: the whole answer, as the command line writes it
    document: Document
    #: one column a name, one value a row
    table: dict[str, Column]

    @classmethod
    def of(cls: type[Kind], native: tuple[str, Iterable[tuple[str, Column]]]) -> Kind:
        """From the text and the columns of the native half."""
        text, columns = native
        return cls(read(text), dict(columns))

    @property
    def says(self) -> str:
        return str(self.document["says"])

    @property
    def unit(self) -> str:
        """Unit of the response."""
        return str(self.document["unit"])

    def to_frame(self) -> Any:
        """The rows as a pandas frame, else a polars one; a dict of arrays where neither is installed."""
        return frame_of(self.table)


class StandsForColumn:
    """What stands for one of its columns where an array is wanted."""

    def _column(self) -> Column:
        raise NotImplementedError

    def __array__(self, dtype: Any = None, copy: bool | None = None) -> npt.NDArray[Any]:
        column = self._column()
        return np.array(column, dtype=dtype) if copy else np.asarray(column, dtype=dtype)

    def __len__(self) -> int:
        return len(self._column())
