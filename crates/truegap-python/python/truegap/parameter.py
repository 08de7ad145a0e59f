"""A number of a simulator that calibration may adjust."""

from __future__ import annotations

import math
from dataclasses import dataclass


@dataclass(frozen=True)
class Parameter:
    """What is known of a parameter before the recording is seen: ``value`` with a standard deviation ``sd``, Gaussian, between ``low`` and ``high``."""

    value: float
    sd: float
    unit: str = ""
    low: float = -math.inf
    high: float = math.inf
    meaning: str = ""


@dataclass(frozen=True)
class Named:
    """A parameter with its name, as the native half reads it."""

    name: str
    value: float
    sd: float
    unit: str
    low: float
    high: float
    meaning: str

    @classmethod
    def of(cls, name: str, parameter: Parameter) -> Named:
        if not isinstance(parameter, Parameter):
            raise TypeError(f"the parameter `{name}` is a {type(parameter).__name__}; write truegap.Parameter(2.0, sd=0.3, unit='N/mm')")
        p = parameter
        return cls(name, float(p.value), float(p.sd), p.unit, float(p.low), float(p.high), p.meaning)
