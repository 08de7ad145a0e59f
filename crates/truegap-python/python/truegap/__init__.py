"""Where a simulation and a recording differ: which physics was left out, how sure is that, and does it predict what the fit has not seen.

    import truegap as tg

    def simulate(inputs, parameters):
        return parameters["k"] * inputs["force_n"]

    d = tg.diagnose(frame, base=simulate, parameters={"k": tg.Parameter(2.0, sd=0.3, unit="mm/N")}, units={"response": "mm"})
    d.verdict, d.findings
"""

from __future__ import annotations

from ._truegap import TruegapError, __version__
from .analytic import audit, coefficients, sensors, simulate
from .asking import confirm, diagnose
from .compensation import Compensation
from .confirmation import Confirmation
from .diagnosis import Diagnosis, Finding, Prediction, Value
from .explain import Explained, effects, explain
from .parameter import Parameter
from .study import optimise, sensitivity, solve, tolerance

__all__ = [
    "Compensation",
    "Confirmation",
    "Diagnosis",
    "Explained",
    "Finding",
    "Parameter",
    "Prediction",
    "TruegapError",
    "Value",
    "__version__",
    "audit",
    "coefficients",
    "confirm",
    "diagnose",
    "effects",
    "explain",
    "optimise",
    "sensitivity",
    "sensors",
    "simulate",
    "solve",
    "tolerance",
]
