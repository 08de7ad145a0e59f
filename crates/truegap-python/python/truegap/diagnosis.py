"""What was found in a recording, as objects."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np

from . import _truegap
from .answer import Document, StandsForColumn, read
from .compensation import Compensation
from .confirmation import Confirmation
from .frames import Path, Recording, has_toml, source
from .tables import Column, frame_of

if TYPE_CHECKING:
    from matplotlib.figure import Figure


@dataclass(frozen=True)
class Value:
    """A fitted number: ``value`` with standard deviation ``sd``, in ``unit``; ``sd_of_fit`` is the part that noise and prior make."""

    name: str
    unit: str
    value: float
    sd: float
    #: what was known before: centre and standard deviation
    prior: tuple[float, float]
    #: whether it stands on a bound
    at_limit: bool
    #: the part of ``sd`` that noise and prior make where the model is right in every respect; the rest is what weak effects and errors of equations may have done
    sd_of_fit: float

    @classmethod
    def of(cls, raw: Mapping[str, Any]) -> Value:
        centre, sd = raw["prior"]
        return cls(raw["name"], raw["unit"], raw["value"], raw["sd"], (centre, sd), raw["at_limit"], raw["sd_of_fit"])

    def __str__(self) -> str:
        unit = "" if self.unit == "1" else f" {self.unit}"
        return f"{self.name} = {self.value:.5g}{unit} (sd {self.sd:.2g})"


@dataclass(frozen=True)
class Finding:
    """Physics that the simulation leaves out."""

    effect: str
    #: that the name is right: how often names were that stood as high among the models
    probability: float
    #: that it belongs to the model, were one of the models that were fitted the truth
    probability_among_models: float
    #: how far it stands out of the noise; None where the model has no answer without it
    detectability: float | None
    says: str
    parameters: tuple[Value, ...]
    #: effects that this recording cannot quite exclude in its place
    rivals: tuple[str, ...]
    #: error on rows left out, without and with it; ``None`` where there is none
    rmse_before: float | None
    rmse_after: float | None
    #: what it is whatever its name: ``place``, ``driver`` and ``kinetics``, each value with its probability; empty where no words say it
    words: Mapping[str, Mapping[str, float]]

    @classmethod
    def of(cls, raw: Mapping[str, Any]) -> Finding:
        parameters = tuple(Value.of(p) for p in raw["parameters"])
        held = raw["held_out"]
        return cls(
            raw["effect"],
            raw["probability"],
            raw.get("probability_among_models", raw["probability"]),
            raw["detectability"],
            raw["says"],
            parameters,
            tuple(raw["rivals"]),
            held["rmse_before"],
            held["rmse_after"],
            raw.get("words", {}),
        )


@dataclass(frozen=True)
class Prediction(StandsForColumn):
    """Response of each row, in ``unit``; stands for the augmented model's where an array is wanted."""

    augmented: Column
    #: of the base model, calibrated alone
    base: Column
    unit: str

    def _column(self) -> Column:
        return self.augmented

    def __repr__(self) -> str:
        if not len(self):
            return "<truegap.Prediction: no row>"
        a = self.augmented
        return f"<truegap.Prediction: {len(a)} rows, augmented {np.nanmin(a):.4g} to {np.nanmax(a):.4g} {self.unit}; .augmented, .base>"


class Diagnosis:
    """A verdict with its reasons, the fuller model, and every row with all predictions."""

    def __init__(
        self,
        native: _truegap.NativeDiagnosis,
        columns: Mapping[str, str] | None,
        units: Mapping[str, str] | None,
        drivers: Mapping[str, Mapping[str, str]] | None,
    ) -> None:
        self._native = native
        self._columns, self._units, self._drivers = columns, units, drivers
        self._confirmed: Confirmation | None = None

    @cached_property
    def document(self) -> Document:
        """The whole answer, as ``diagnosis.json`` holds it."""
        return read(self._native.json())

    @property
    def verdict(self) -> str:
        """``agrees``, ``explained``, ``ambiguous``, ``wrong_form``, ``unexplained`` or ``undecided``."""
        return str(self.document["verdict"])

    @property
    def says(self) -> str:
        return str(self.document["says"])

    @property
    def findings(self) -> list[Finding]:
        return [Finding.of(raw) for raw in self.document["findings"]]

    @property
    def carried(self) -> list[Finding]:
        """Smaller effects of the same model; their names are not claimed."""
        return [Finding.of(raw) for raw in self.document.get("carried", [])]

    @property
    def ambiguity(self) -> list[list[str]]:
        """Sets of effects of which the recording cannot tell the members apart."""
        return [list(names) for names in self.document["ambiguity"]]

    @property
    def probability_agrees(self) -> float:
        return float(self.document["probability_agrees"])

    @property
    def unit(self) -> str:
        """Unit of the response."""
        return str(self.document["fit"]["unit"])

    @property
    def noise(self) -> float:
        """Noise of one row, in ``unit``."""
        return float(self.document["fit"]["noise_floor"])

    @property
    def base_parameters(self) -> list[Value]:
        """Numbers of the simulation, calibrated with the findings added."""
        return [Value.of(raw) for raw in self.document["base"]["parameters_after"]]

    @property
    def next_experiment(self) -> str:
        return str(self.document["next_experiment"]["says"])

    @property
    def notes(self) -> list[str]:
        """What reading the recording changed, left out or assumed."""
        return self._native.notes()

    @property
    def calls(self) -> tuple[int, float]:
        """How often a function or a program was asked, and the seconds that this took; answers that were remembered are not counted."""
        return self._native.calls()

    @property
    def table(self) -> dict[str, Column]:
        """Every row with all predictions, as in ``prediction.csv``, not rounded."""
        return dict(self._native.table())

    def to_frame(self) -> Any:
        """The same as a pandas frame, else a polars one; a dict of arrays where neither is installed."""
        return frame_of(self.table)

    def predict(
        self,
        recording: Recording,
        *,
        columns: Mapping[str, str] | None = None,
        units: Mapping[str, str] | None = None,
        drivers: Mapping[str, Mapping[str, str]] | None = None,
    ) -> Prediction:
        """What base and augmented model answer to other inputs; a frame needs no reading. Names and units are those of the diagnosis unless given."""
        other = self._source(recording, columns, units, drivers, reading=False)
        augmented, base = self._native.predict(other)
        return Prediction(augmented, base, self.unit)

    def confirm(
        self,
        recording: Recording,
        *,
        free: Sequence[str] = (),
        channel: str | None = None,
        columns: Mapping[str, str] | None = None,
        units: Mapping[str, str] | None = None,
        drivers: Mapping[str, Mapping[str, str]] | None = None,
    ) -> Confirmation:
        """Whether a recording that took no part bears out what was added; nothing is refitted but ``free``: gain, offset, clock."""
        self._confirmed = Confirmation.of(self._native.confirm(self._source(recording, columns, units, drivers), list(free), channel))
        return self._confirmed

    def compensate(
        self,
        recording: Recording,
        *,
        all: bool = False,
        carried: bool = False,
        channel: str | None = None,
        columns: Mapping[str, str] | None = None,
        units: Mapping[str, str] | None = None,
        drivers: Mapping[str, Mapping[str, str]] | None = None,
    ) -> Compensation:
        """The readings without what was added; the load need not be in the frame. ``all``: the recording began as the diagnosed one did, so drift and settling are taken away as well; ``carried``: what the model carries without a claim to its name, too."""
        return Compensation.of(self._native.compensate(self._source(recording, columns, units, drivers), channel, all, carried))

    def _source(
        self,
        recording: Recording,
        columns: Mapping[str, str] | None,
        units: Mapping[str, str] | None,
        drivers: Mapping[str, Mapping[str, str]] | None,
        reading: bool = True,
    ) -> _truegap.Source:
        if not has_toml(recording):
            columns = self._columns if columns is None else columns
            units = self._units if units is None else units
            drivers = self._drivers if drivers is None else drivers
        return source(recording, name="frame", columns=columns, units=units, drivers=drivers, base=None, reading=reading)

    def plot(self) -> Figure:
        """Recording and models above, what each leaves over below, with the noise; needs matplotlib."""
        from .plot import figure

        return figure(self)

    def save(self, folder: Path) -> None:
        """Write ``report.html``, ``diagnosis.json``, ``augmented.toml`` and ``prediction.csv``, all or none, as the command line does."""
        self._native.save(folder)

    @property
    def model_toml(self) -> str:
        """The fuller model, as ``augmented.toml`` holds it."""
        return self._native.model_toml()

    def report_html(self) -> str:
        """The page, as ``report.html`` holds it."""
        return self._native.html()

    def __str__(self) -> str:
        return self._native.summary()

    def __repr__(self) -> str:
        found = " + ".join(f"{f.effect} ({f.probability:.2f})" for f in self.findings)
        return f"<truegap.Diagnosis: {self.verdict}{': ' + found if found else ''}>"

    def _repr_html_(self) -> str:
        """The report's first screen, and the last confirmation that was asked for."""
        confirmed = "" if self._confirmed is None else self._confirmed._repr_html_()
        return self._native.first_screen() + confirmed
