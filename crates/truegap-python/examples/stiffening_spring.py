"""A mass on a spring that stiffens, recorded twice, beside a simulation in which the spring is linear.

Made here, so that the truth is known: m x'' + c x' + k x + k3 x^3 = F. What comes out, and what it is worth:

1. With the linear simulator the diagnosis finds that a spring inside of it stiffens, and how much: the simulator is asked again with the load that such a spring
   leaves, until load and response are at one. The second recording, which took no part, confirms it.
2. With the cubic term as one more parameter of the simulator the same diagnosis agrees, finds the same size, and predicts the second recording to its noise.

Run it: python stiffening_spring.py [FOLDER]
"""

from __future__ import annotations

import sys
from typing import Any

import numpy as np
import numpy.typing as npt

import truegap as tg

Column = npt.NDArray[np.float64]
M, C, K, K3, STEP = 1.0, 0.8, 40.0, 30.0, 0.02  # kg, N s/m, N/m, N/m^3, s
NOISE = 2e-3  # m


def linear(inputs: dict[str, Column], parameters: dict[str, float]) -> Column:
    """The simulator that one has."""
    return cubic(inputs, {**parameters, "k3": 0.0})


def cubic(inputs: dict[str, Column], parameters: dict[str, float]) -> Column:
    """The one that one writes next. Semi-implicit Euler, one step a row."""
    c, k, k3 = (parameters[name] for name in ("c", "k", "k3"))
    x, v, moved = 0.0, 0.0, []
    for force in inputs["force_n"].tolist():
        v += STEP * (force - c * v - k * x - k3 * x * x * x) / M
        x += STEP * v
        moved.append(x)
    return np.array(moved)


def recorded(seed: int, rows: int = 600) -> dict[str, Any]:
    """A shaken mass, its displacement read with 2 mm of noise."""
    random = np.random.default_rng(seed)
    time = STEP * np.arange(rows)
    waves = [(random.uniform(2, 5), random.uniform(0.2, 6.0), random.uniform(0, 2 * np.pi)) for _ in range(5)]
    force = np.sum([size * np.sin(rate * time + phase) for size, rate, phase in waves], axis=0)
    moved = cubic({"force_n": force}, {"c": C, "k": K, "k3": K3})
    return {"time_s": time, "force_n": force, "displacement": moved + random.normal(0, NOISE, rows)}


KNOWN = {"k": tg.Parameter(38.0, sd=4.0, unit="N/m", low=1.0), "c": tg.Parameter(1.0, sd=0.4, unit="N s/m", low=0.0)}
WITH_K3 = {**KNOWN, "k3": tg.Parameter(0.0, sd=50.0, unit="N/m3")}
COLUMNS, UNITS = {"response": "displacement"}, {"response": "m"}


def error(d: tg.Diagnosis, other: dict[str, Any]) -> float:
    """Error of the augmented model on a recording that took no part, m."""
    return float(np.sqrt(np.mean((d.predict(other).augmented - other["displacement"]) ** 2)))


def main(folder: str | None = None) -> tuple[tg.Diagnosis, tg.Confirmation, tg.Diagnosis]:
    first, other = recorded(1), recorded(2)
    before = tg.diagnose(first, base=linear, parameters=KNOWN, columns=COLUMNS, units=UNITS)
    print(before, "\n")
    confirmation = before.confirm(other)
    print(confirmation.verdict, "-", confirmation.says, "\n")
    after = tg.diagnose(first, base=cubic, parameters=WITH_K3, columns=COLUMNS, units=UNITS)
    print(after)
    print(*after.base_parameters, sep="\n")
    print(f"error on the other recording: {error(before, other):.4f} m before, {error(after, other):.4f} m after; noise {NOISE} m")
    if folder is not None:
        before.save(folder)
        before.plot().savefig(f"{folder}.svg")
    return before, confirmation, after


if __name__ == "__main__":
    main(*sys.argv[1:2])
